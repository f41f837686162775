#include "wavecurve/motion/morph/make_morph.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/motion/chain.hpp"
#include "wavecurve/motion/detail/blend_paint.hpp"
#include "wavecurve/motion/morph/detail/exchange_times.hpp"
#include "wavecurve/motion/morph/detail/held_corners.hpp"
#include "wavecurve/motion/morph/detail/orientation.hpp"
#include "wavecurve/motion/morph/detail/painting_order.hpp"
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

FrameLayer sampled(const Layer& layer, Index samples) {
  // A miter shows where the corner is.
  const bool has_corners = layer.paint.stroke && layer.paint.line_join != LineJoin::round;
  FrameLayer result{layer.id, {}, layer.paint};
  try {
    result.contours = sample_layer(layer, samples, has_corners ? Corners::kept : Corners::ignored);
  } catch (const std::invalid_argument&) {  // more corners than samples
    result.contours = sample_layer(layer, samples);
  }
  const auto rule = layer.paint.fill ? std::optional(layer.paint.fill_rule) : std::nullopt;
  Orientation orientation = oriented(std::move(result.contours), rule);
  result.contours = std::move(orientation.contours);
  result.paint.fill_rule = orientation.nonzero ? FillRule::nonzero : FillRule::evenodd;
  for (const Subpath& subpath : layer.subpaths) {
    result.open.push_back(!subpath.closed && !layer.paint.fill);
  }
  return result;
}

Layers sampled(const Drawing& drawing, Index samples) {
  Layers layers;
  for (const Layer& layer : drawing.layers) layers.push_back(sampled(layer, samples));
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

/// Layers whose contours are mapped are matched, too.
LayerMap with_mapped_contours(const MorphOptions& options) {
  LayerMap map = options.map;
  for (const MappedContours& one : options.contours) {
    const std::pair layers(one.source_layer, one.destination_layer);
    if (std::find(map.begin(), map.end(), layers) == map.end()) map.push_back(layers);
  }
  return map;
}

/// Anchors need a layer that has a partner, and no start besides.
void check_layers_met(const std::vector<LayerMatch>& matches, const Layers& source,
                      const MorphOptions& options) {
  for (const Anchor& anchor : options.anchors) {
    const bool is_met = std::any_of(matches.begin(), matches.end(), [&](const LayerMatch& match) {
      return match.source && match.destination && source[*match.source].id == anchor.layer;
    });
    if (!is_met) {
      throw std::invalid_argument(
          fmt::format("the anchor {}:{}={} fits no layer of the source that has a partner",
                      anchor.layer, anchor.source, anchor.destination));
    }
    if (start_of(anchor.layer, options)) {
      throw std::invalid_argument(
          fmt::format("layer '{}' has an anchor and a start; one of them decides", anchor.layer));
    }
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

bool is_outline_of_solid(const FrameLayer& layer, const FrameLayer& other) {
  return layer.paint.stroke && !layer.paint.fill && other.paint.fill;
}

/// An outline as a solid of no area: with a hole as large as each closed contour. So it fills from
/// its rim on, and is never half there.
FrameLayer with_holes(FrameLayer layer) {
  const std::size_t count = layer.contours.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (is_open(layer, i)) continue;
    Contour hole = layer.contours[i];
    hole.bottomRows(hole.rows() - 1) = hole.bottomRows(hole.rows() - 1).colwise().reverse().eval();
    layer.contours.push_back(std::move(hole));
    layer.open.push_back(false);
  }
  return layer;
}

/// Whether a contour turns as holes do: a line there and back, which encloses nothing but rounding errors, does not.
bool turns_as_hole(const Contour& contour) {
  const auto sizes = contour.colwise().maxCoeff() - contour.colwise().minCoeff();
  return signed_area(contour) < -1e-9 * sizes.squaredNorm();
}

Paint stroke_of(Paint paint) {
  paint.fill.reset();
  return paint;
}

Paint fill_of(Paint paint) {
  paint.stroke.reset();
  return paint;
}

/// The contours that the options match in two layers.
ContourMap contour_map(const MorphOptions& options, const std::string& source,
                       const std::string& destination) {
  ContourMap map;
  for (const MappedContours& one : options.contours) {
    if (one.source_layer == source && one.destination_layer == destination) {
      map.emplace_back(one.source, one.destination);
    }
  }
  return map;
}

VertexPairs anchors_of(const MorphOptions& options, const std::string& layer) {
  VertexPairs anchors;
  for (const Anchor& anchor : options.anchors) {
    if (anchor.layer == layer) anchors.emplace_back(anchor.source, anchor.destination);
  }
  return anchors;
}

/// Makes the layers of a morph; each ground is that of a whole drawing.
struct LayerMaker {
  const MorphOptions& options;
  const Drawing &source_drawing, &destination_drawing;  ///< in one box
  double same_place;                                    ///< distance of points that are one
  std::vector<Contour> source_ground, destination_ground;

  MorphLayer layer(const std::string& id, std::vector<ContourPair> contours, const Paint& from,
                   const Paint& to) const {
    return {id, std::move(contours), blend_paint(from, to, options.duration),
            options.scale.value_or(options.samples)};
  }

  MorphLayer vanishing_layer(const FrameLayer& source) const {
    return layer(source.id, shrink_contours(source, destination_ground), source.paint,
                 vanishing(source.paint));
  }
  MorphLayer appearing_layer(const FrameLayer& destination) const {
    return layer(destination.id, reversed(shrink_contours(destination, source_ground)),
                 vanishing(destination.paint), destination.paint);
  }

  std::vector<MorphLayer> layers(const LayerMatch& match, const Layers& from,
                                 const Layers& to) const {
    if (!match.destination) return {vanishing_layer(from[*match.source])};
    if (!match.source) return {appearing_layer(to[*match.destination])};
    HeldVertices holder(source_drawing.layers[*match.source],
                        destination_drawing.layers[*match.destination],
                        anchors_of(options, from[*match.source].id), same_place);
    auto layers = paired_layers(from[*match.source], to[*match.destination], holder);
    holder.check_found();
    return layers;
  }

  std::vector<MorphLayer> paired_layers(const FrameLayer& source, const FrameLayer& destination,
                                        HeldVertices& holder) const {
    const bool opens = is_outline_of_solid(source, destination);
    const bool closes = is_outline_of_solid(destination, source);
    const auto start = start_of(source.id, options);
    HeldPair held;
    if (!start && (options.shared_corners == Corners::kept || holder.has_anchors())) {
      held = [&](std::size_t i, std::size_t j) { return holder.pair(source, destination, i, j); };
    }
    ContourPairs pairs = pair_contours(
        opens ? with_holes(source) : source, closes ? with_holes(destination) : destination,
        options.rotation, start, contour_map(options, source.id, destination.id), held);
    const bool has_stroke = source.paint.stroke || destination.paint.stroke;
    const bool all_last = pairs.vanishing.empty() && pairs.appearing.empty();
    if (!has_stroke || (all_last && !opens && !closes)) {
      return {layer(source.id, all(pairs), source.paint, destination.paint)};
    }
    std::vector<MorphLayer> layers = fill_layers(source, destination, pairs);
    if (opens) take_holes_from_strokes(pairs.lasting, pairs.vanishing, pairs.appearing, +1);
    if (closes) take_holes_from_strokes(pairs.lasting, pairs.appearing, pairs.vanishing, -1);
    for (MorphLayer& stroke : stroke_layers(source, destination, std::move(pairs))) {
      layers.push_back(std::move(stroke));
    }
    return layers;
  }

  /// The fill of all contours, without strokes.
  std::vector<MorphLayer> fill_layers(const FrameLayer& source, const FrameLayer& destination,
                                      const ContourPairs& pairs) const {
    if (!source.paint.fill && !destination.paint.fill) return {};
    MorphLayer fill = layer(source.id, all(pairs), source.paint, destination.paint);
    for (PaintKey& key : fill.paint) key.paint = fill_of(key.paint);
    std::erase_if(fill.contours, [](const ContourPair& pair) { return pair.open; });
    if (fill.contours.empty()) return {};
    return {fill};
  }

  /// The holes of with_holes are not stroked, since their outlines are. Those that become holes of
  /// the solid are stroked as these are, where they are there.
  static void take_holes_from_strokes(std::vector<ContourPair>& lasting,
                                      std::vector<ContourPair>& of_outline,
                                      std::vector<ContourPair>& of_solid, int direction) {
    const auto is_hole = [&](const ContourPair& pair) {
      return turns_as_hole(direction > 0 ? pair.source : pair.destination);
    };
    std::erase_if(of_outline, is_hole);
    std::copy_if(lasting.begin(), lasting.end(), std::back_inserter(of_solid), is_hole);
    std::erase_if(lasting, is_hole);
  }

  /// Strokes that have no width where their contours are points.
  std::vector<MorphLayer> stroke_layers(const FrameLayer& source, const FrameLayer& destination,
                                        ContourPairs pairs) const {
    const Paint from = stroke_of(source.paint), to = stroke_of(destination.paint);
    std::vector<MorphLayer> layers;
    if (!pairs.lasting.empty()) {
      layers.push_back(layer(source.id, std::move(pairs.lasting), source.paint, destination.paint));
      for (PaintKey& key : layers.back().paint) key.paint = stroke_of(key.paint);
    }
    if (from.stroke && !pairs.vanishing.empty()) {
      layers.push_back(layer(source.id, std::move(pairs.vanishing), from, vanishing(from)));
    }
    if (to.stroke && !pairs.appearing.empty()) {
      layers.push_back(layer(source.id, std::move(pairs.appearing), vanishing(to), to));
    }
    return layers;
  }

  static std::vector<ContourPair> all(const ContourPairs& pairs) {
    std::vector<ContourPair> result = pairs.lasting;
    result.insert(result.end(), pairs.appearing.begin(), pairs.appearing.end());
    result.insert(result.end(), pairs.vanishing.begin(), pairs.vanishing.end());
    return result;
  }
};

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
  const Drawing in_box = fitted(destination, source.view_box);
  const LayerMaker maker{options, source, in_box, 1e-6 * diagonal, ground(from), ground(to)};
  const std::vector<LayerMatch> matches =
      match_layers(from, to, diagonal, with_mapped_contours(options));
  check_layers_met(matches, from, options);
  std::set<std::string> ids;
  std::vector<std::vector<std::size_t>> of_match;  // the layers made of it
  for (const LayerMatch& match : matches) {
    of_match.emplace_back();
    for (MorphLayer& layer : maker.layers(match, from, to)) {
      make_unique(layer.id, ids);
      for (ContourPair& pair : layer.contours) {
        pair.source = to_coefficients(options.bank, pair.source, morph.levels);
        pair.destination = to_coefficients(options.bank, pair.destination, morph.levels);
      }
      of_match.back().push_back(morph.layers.size());
      morph.layers.push_back(std::move(layer));
    }
  }
  std::vector<std::size_t> end;
  for (const std::size_t match : final_painting_order(matches, from, to)) {
    end.insert(end.end(), of_match[match].begin(), of_match[match].end());
  }
  if (!std::is_sorted(end.begin(), end.end())) morph.order = exchange_times(animate(morph), end);
  return morph;
}

}  // namespace wavecurve::motion
