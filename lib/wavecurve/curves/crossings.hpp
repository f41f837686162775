#pragma once

#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"

namespace wavecurve {

/// Whether an edge joins the last point of a polygon to the first.
enum class Closing { joined, open };

/// The number of proper crossings of a polygon with itself: pairs of edges that have exactly
/// one point in common, inside both. Edges that merely touch, share an end or overlap along a line
/// do not cross. Never wrong, since the predicate is exact (orient2d).
///
/// Edges are found by a binary tree of bounding boxes along the contour, so the time is O(N log N)
/// plus the pairs of edges whose boxes meet. Those are O(N) where edges are short against the
/// shape, as in contours sampled by arc length: besides its neighbours an edge then meets only the
/// edges of parts that cross it or come as near as its own length.
/// Throws std::domain_error unless all coordinates are finite.
Eigen::Index count_crossings(const Eigen::Ref<const Contour>& contour,
                             Closing closing = Closing::joined);

/// The number of proper crossings between two closed polygons; the same in every other respect.
Eigen::Index count_crossings(const Eigen::Ref<const Contour>& a,
                             const Eigen::Ref<const Contour>& b);

/// All proper crossings of an outline: of each contour with itself and with each other one.
Eigen::Index count_crossings(const std::vector<Contour>& outline);

}  // namespace wavecurve

namespace wavecurve::plain {

/// The same by the definition: every pair of edges. O(N^2).
Eigen::Index count_crossings(const Eigen::Ref<const Contour>& contour,
                             Closing closing = Closing::joined);
Eigen::Index count_crossings(const Eigen::Ref<const Contour>& a,
                             const Eigen::Ref<const Contour>& b);

}  // namespace wavecurve::plain
