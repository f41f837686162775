#pragma once

#include <optional>
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

/// Pairs of corresponding points of two layers, both oriented, of N points each. Outer contours go
/// with outer ones, holes with holes and open lines with open lines, so that the distances of means
/// and the differences of the roots of areas sum up to the least. An open line goes with an outer
/// contour too, as one that runs there and back, where the joins of its paint look like its caps.
///
/// What is left over grows from, or shrinks to, a point inside the nearest outer contour of the other
/// outline: its own inner point, if that lies there, so that it stays where it is. Points correspond
/// by best_shift, or by the start given; two open lines by their ends.
ContourPairs pair_contours(const FrameLayer& source, const FrameLayer& destination,
                           Rotation rotation, std::optional<Eigen::Index> start);

/// The same with nothing on the other side but what lies there of other layers, the ground: every
/// contour shrinks to a point.
std::vector<ContourPair> shrink_contours(const FrameLayer& source,
                                         const std::vector<Contour>& ground);

/// Source and destination exchanged.
std::vector<ContourPair> reversed(std::vector<ContourPair> pairs);

}  // namespace wavecurve::motion
