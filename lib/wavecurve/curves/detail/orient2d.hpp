#pragma once

#include <Eigen/Core>

namespace wavecurve {

/// The sign of the turn a -> b -> c, that is of the determinant
///   (a_x - c_x)(b_y - c_y) - (a_y - c_y)(b_x - c_x):
/// 1 if it turns clockwise as seen with y pointing down, -1 if the other way, 0 if the points lie
/// on a line. Exact: a rounded determinant decides where it exceeds its error bound, elsewhere the
/// products are summed as an expansion without rounding (Shewchuk, Adaptive Precision
/// Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997). Coordinates must be
/// finite; products of two must neither overflow nor, unless zero, lie below 2^-960.
int orient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace wavecurve
