#pragma once

#include <cstddef>
#include <vector>

namespace wavecurve::tracking {

/// Where the level of a series changes: the indices of the first values of new levels. Penalised
/// least squares by optimal partitioning (Jackson et al., IEEE Signal Processing Letters 12, 2005;
/// exact, as PELT is, which prunes the same recursion): the segmentation that minimises
///   sum over segments of (squares about the segment's mean) / s^2 + 3 ln n a segment.
/// s is estimated from successive differences, 1.4826 / sqrt 2 times the median of their
/// magnitudes, which a change of level enters but once; at least `least_noise`, since a series of
/// counts may repeat exactly.
std::vector<std::size_t> change_points(const std::vector<double>& values, double least_noise);

}  // namespace wavecurve::tracking
