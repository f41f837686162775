#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wavecurve/motion/animation.hpp"

namespace wavecurve::motion {

/// Indices of layers that become each other; one of them alone appears or vanishes.
struct LayerMatch {
  std::optional<std::size_t> source, destination;
};

/// Ids of a source and a destination layer that belong together, whatever else speaks against it.
using LayerMap = std::vector<std::pair<std::string, std::string>>;

/// Matches the layers of two drawings: those of the map, then those of equal ids, then as many of
/// the rest as there are on both sides, by the least sum of costs. In painting_order.
///
/// The cost of a pair is the distance of their centroids and the difference of the square roots of
/// their areas, both relative to the diagonal of the view box, and the distance of their colours in
/// OKLab (1 between black and white, and between a fill and none).
///
/// Layers are not matched that no fill rule fills both as their own rules do: contours that cross
/// each other under the even-odd rule, and the like under the other.
///
/// Ids that only number the layers say nothing: those of a drawing whose layers all have one stem,
/// such as L00, L01, L02, and those of an SVG element's name and a number, such as path-3, which
/// read_drawing gives to what has none.
/// Throws std::invalid_argument for a map that names an unknown layer, or one twice.
std::vector<LayerMatch> match_layers(const std::vector<FrameLayer>& source,
                                     const std::vector<FrameLayer>& destination, double diagonal,
                                     const LayerMap& map = {});

}  // namespace wavecurve::motion
