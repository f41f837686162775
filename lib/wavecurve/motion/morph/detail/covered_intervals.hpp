#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "wavecurve/motion/animation.hpp"

namespace wavecurve::motion {

/// What a layer covers along horizontal lines: of each line disjoint intervals, from left to right.
using CoveredIntervals = std::vector<std::vector<std::pair<double, double>>>;

/// The lines lie at the middles of equal shares of the height of a box. A fill covers what is inside by its rule, a
/// stroke its width about each place where a line meets it.
CoveredIntervals covered_intervals(const FrameLayer& layer, const ViewBox& box, std::size_t lines);

/// The length of what both cover, of all lines together.
double shared_length(const CoveredIntervals& a, const CoveredIntervals& b);

/// Whether the fills of two layers have an area in common, as 64 lines of the box see it that both boxes have in
/// common. Where outlines only touch there is none; where they lie on each other, there is.
bool share_area(const FrameLayer& a, const FrameLayer& b);

}  // namespace wavecurve::motion
