#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/motion/morph/morph.hpp"

namespace wavecurve::motion {

/// The contours of a layer: those that become each other, and those of one side alone, which shrink
/// to a point or grow from one.
struct ContourPairs {
  std::vector<ContourPair> lasting, vanishing, appearing;
};

/// Contours of two layers by their indices: those that belong together, whatever else speaks against it.
using ContourMap = std::vector<std::pair<std::size_t, std::size_t>>;

/// The pair of contour i of the source and contour j of the destination, if it has points that are held.
using HeldPair = std::function<std::optional<ContourPair>(std::size_t i, std::size_t j)>;

/// Pairs of corresponding points of two layers, both oriented, of N points each. Outer contours go
/// with outer ones, holes with holes and open lines with open lines, so that the distances of means
/// and the differences of the roots of areas sum up to the least. An open line goes with an outer
/// contour too, as one that runs there and back, where the joins of its paint look like its caps.
///
/// What is left over grows from, or shrinks to, a point inside the nearest outer contour of the other
/// outline: its own inner point, if that lies there, so that it stays where it is. Points correspond
/// as the held pair has them, else by the start given, else by best_shift; two open lines by their ends.
/// Throws std::invalid_argument for a map that names an unknown contour, one twice, or two of different
/// kinds.
ContourPairs pair_contours(const FrameLayer& source, const FrameLayer& destination,
                           Rotation rotation, std::optional<Eigen::Index> start,
                           const ContourMap& map = {}, const HeldPair& held = {});

/// The same with nothing on the other side but what lies there of other layers, the ground: every
/// contour shrinks to a point.
std::vector<ContourPair> shrink_contours(const FrameLayer& source,
                                         const std::vector<Contour>& ground);

/// Source and destination exchanged.
std::vector<ContourPair> reversed(std::vector<ContourPair> pairs);

}  // namespace wavecurve::motion
