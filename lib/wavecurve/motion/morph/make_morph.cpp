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

Layers sampled(const Drawing& drawing, Index samples) {
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

double contours_of(const Drawing& drawing) {
  double count = 0;
  for (const Layer& layer : drawing.layers) count += static_cast<double>(layer.subpaths.size());
  return count;
}

/// What is refused here would take minutes, or more memory than there is.
void check_size(const Drawing& source, const Drawing& destination, Index samples) {
  constexpr long most_layers = 10'000;
  constexpr double most_points = double{1 << 25}, most_pairs = 1e10;
  check_samples(samples);
  const double points = static_cast<double>(samples);
  for (const Drawing* drawing : {&source, &destination}) {
    const std::string which = drawing == &source ? "source" : "destination";
    const auto layers = static_cast<long>(drawing->layers.size());
    check_between("the number of layers of the " + which, layers, 1, most_layers);
    if (contours_of(*drawing) * points <= most_points) continue;
    throw std::domain_error(
        fmt::format("the {} has {} contours; of {} samples each, they are more than {} points",
                    which, contours_of(*drawing), samples, most_points));
  }
  if (contours_of(source) * contours_of(destination) * points <= most_pairs) return;
  throw std::domain_error(
      fmt::format("{} and {} contours of {} samples cannot be matched: the product is above {}",
                  contours_of(source), contours_of(destination), samples, most_pairs));
}

/// A layer with its contours as points; each ground is that of a whole drawing.
MorphLayer pair_layers(const FrameLayer* source, const FrameLayer* destination,
                       const std::vector<Contour>& source_ground,
                       const std::vector<Contour>& destination_ground,
                       const MorphOptions& options) {
  MorphLayer layer;
  layer.id = source ? source->id : destination->id;
  layer.scale = options.scale.value_or(options.samples);
  if (source && destination) {
    layer.contours = pair_contours(source->contours, destination->contours, options.rotation,
                                   start_of(source->id, options));
    layer.paint = blend_paint(source->paint, destination->paint, options.duration);
  } else if (source) {
    layer.contours = shrink_contours(source->contours, destination_ground);
    layer.paint = blend_paint(source->paint, vanishing(source->paint), options.duration);
  } else {
    layer.contours = reversed(shrink_contours(destination->contours, source_ground));
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
  check_size(source, destination, options.samples);
  const Layers from = sampled(source, options.samples);
  Layers to = sampled(destination, options.samples);
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
  const std::vector<Contour> source_ground = ground(from), destination_ground = ground(to);
  std::set<std::string> ids;
  for (const LayerMatch& match : match_layers(from, to, diagonal, options.map)) {
    MorphLayer layer = pair_layers(match.source ? &from[*match.source] : nullptr,
                                   match.destination ? &to[*match.destination] : nullptr,
                                   source_ground, destination_ground, options);
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
