#include "wavecurve/motion/morph/make_morph.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/motion/detail/blend_paint.hpp"
#include "wavecurve/motion/morph/detail/pair_contours.hpp"

namespace wavecurve::motion {

namespace {

using Eigen::Index;
using Layers = std::vector<FrameLayer>;

/// Levels down to four control points.
int levels_to_four(Index samples) {
  int levels = 0;
  while (samples >> (levels + 1) >= 4) ++levels;
  return levels;
}

Layers sampled(const Drawing& drawing, Index samples, const char* which) {
  if (drawing.layers.empty()) {
    throw std::invalid_argument(fmt::format("the {} has no layers", which));
  }
  Layers layers;
  for (const Layer& layer : drawing.layers) {
    const auto rule = layer.paint.fill ? std::optional(layer.paint.fill_rule) : std::nullopt;
    layers.push_back({layer.id, oriented(sample_layer(layer, samples), rule), layer.paint});
  }
  return layers;
}

/// Scales and moves the layers from the centre of one box to that of another, as large as fits.
void fit(Layers& layers, const ViewBox& from, const ViewBox& to) {
  if (from == to) return;
  const double scale = std::min(to.width / from.width, to.height / from.height);
  const Eigen::RowVector2d from_centre(from.x + from.width / 2, from.y + from.height / 2);
  const Eigen::RowVector2d to_centre(to.x + to.width / 2, to.y + to.height / 2);
  for (FrameLayer& layer : layers) {
    layer.paint.stroke_width *= scale;
    for (Contour& contour : layer.contours) {
      contour = ((contour.rowwise() - from_centre) * scale).rowwise() + to_centre;
    }
  }
}

/// The outer contours of all layers, those of small area, which lie on top of larger ones, first.
std::vector<Contour> ground(const Layers& layers) {
  std::vector<Contour> contours;
  for (const FrameLayer& layer : layers) {
    for (const Contour& contour : layer.contours) {
      if (signed_area(contour) > 0) contours.push_back(contour);
    }
  }
  return contours;
}

std::optional<Index> start_of(const std::string& id, const MorphOptions& options) {
  for (const auto& [layer, start] : options.starts) {
    if (layer == id) return start;
  }
  return std::nullopt;
}

void check_starts(const Layers& source, const MorphOptions& options) {
  for (const auto& [id, start] : options.starts) {
    const bool is_known =
        std::any_of(source.begin(), source.end(),
                    [&wanted = id](const auto& layer) { return layer.id == wanted; });
    if (!is_known) {
      throw std::invalid_argument(
          fmt::format("the start {}={} fits no layer of the source", id, start));
    }
    check_between(fmt::format("the start of layer '{}'", id), start, 0, options.samples - 1);
  }
}

/// A layer with its contours as points.
MorphLayer pair_layers(const FrameLayer* source, const FrameLayer* destination,
                       const Layers& all_source, const Layers& all_destination,
                       const MorphOptions& options) {
  MorphLayer layer;
  layer.id = source ? source->id : destination->id;
  layer.scale = options.scale.value_or(options.samples);
  if (source && destination) {
    layer.contours = pair_contours(source->contours, destination->contours, options.rotation,
                                   start_of(source->id, options));
    layer.paint = blend_paint(source->paint, destination->paint, options.duration);
  } else if (source) {
    layer.contours = shrink_contours(source->contours, ground(all_destination));
    layer.paint = blend_paint(source->paint, vanishing(source->paint), options.duration);
  } else {
    layer.contours = reversed(shrink_contours(destination->contours, ground(all_source)));
    layer.paint = blend_paint(vanishing(destination->paint), destination->paint, options.duration);
  }
  return layer;
}

void make_unique(std::string& id, std::set<std::string>& taken) {
  const std::string stem = id;
  for (int number = 2; !taken.insert(id).second; ++number) {
    id = fmt::format("{}-{}", stem, number);
  }
}

}  // namespace

Morph make_morph(const Drawing& source, const Drawing& destination, const MorphOptions& options) {
  const Layers from = sampled(source, options.samples, "source");
  Layers to = sampled(destination, options.samples, "destination");
  fit(to, destination.view_box, source.view_box);
  check_starts(from, options);
  Morph morph{source.view_box,
              options.bank,
              levels_to_four(options.samples),
              options.detail,
              options.stage_share,
              options.duration,
              {}};
  const double diagonal = std::hypot(source.view_box.width, source.view_box.height);
  std::set<std::string> ids;
  for (const LayerMatch& match : match_layers(from, to, diagonal, options.map)) {
    MorphLayer layer =
        pair_layers(match.source ? &from[*match.source] : nullptr,
                    match.destination ? &to[*match.destination] : nullptr, from, to, options);
    make_unique(layer.id, ids);
    for (ContourPair& pair : layer.contours) {
      pair.source = to_coefficients(options.bank, pair.source, morph.levels);
      pair.destination = to_coefficients(options.bank, pair.destination, morph.levels);
    }
    morph.layers.push_back(std::move(layer));
  }
  return morph;
}

}  // namespace wavecurve::motion
