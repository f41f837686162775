#pragma once

#include <optional>
#include <vector>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/motion/morph/morph.hpp"

namespace wavecurve::motion {

/// An outline with outer contours clockwise and holes counter-clockwise, so that it is filled alike
/// by either rule. Contours may be reversed, the shape stays. Without a rule, as in what is only
/// stroked, nothing is a hole.
std::vector<Contour> oriented(std::vector<Contour> outline, std::optional<FillRule> rule);

/// Whether points i and N - i coincide but for rounding: an open stroke, run through there and
/// back.
bool is_there_and_back(const Eigen::Ref<const Contour>& contour);

/// Pairs of corresponding points, both contours oriented, of N points each. Outer contours go with
/// outer ones and holes with holes, so that the distances of means and the differences of the roots
/// of areas sum up to the least; one that is left over grows from, or shrinks to, a point inside
/// the nearest outer contour of the other outline: its own inner point, if that lies there, so that
/// it stays where it is. Points correspond by best_shift, or by the start given; two strokes that
/// are run through there and back by their ends.
std::vector<ContourPair> pair_contours(const std::vector<Contour>& source,
                                       const std::vector<Contour>& destination, Rotation rotation,
                                       std::optional<Eigen::Index> start);

/// The same with nothing on the other side but what lies there of other layers, the ground: every
/// contour shrinks to a point.
std::vector<ContourPair> shrink_contours(const std::vector<Contour>& source,
                                         const std::vector<Contour>& ground);

/// Source and destination exchanged.
std::vector<ContourPair> reversed(std::vector<ContourPair> pairs);

}  // namespace wavecurve::motion
