#pragma once

#include <vector>

#include <Eigen/Core>

namespace wavecurve {

/// The Bezier segment B(s) = sum_i binomial(degree, i) s^i (1 - s)^(degree - i) control_i,
/// 0 <= s <= 1; control points are columns, degree 1 (a line), 2 or 3.
struct BezierSegment {
  Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, 4> control;

  int degree() const { return static_cast<int>(control.cols()) - 1; }
};

/// A connected piece of a path: each segment starts where the one before ends. A closed one ends
/// where it starts, with the closing line, if it has a length, as its last segment.
struct Subpath {
  std::vector<BezierSegment> segments;
  bool closed = false;
};

}  // namespace wavecurve
