#include "wavecurve/curves/detail/bezier.hpp"

namespace wavecurve {

Eigen::Vector2d bezier_point(const BezierSegment& segment, double s) {
  auto control = segment.control;
  for (int count = segment.degree(); count > 0; --count) {
    for (int i = 0; i < count; ++i) {
      control.col(i) = (1 - s) * control.col(i) + s * control.col(i + 1);
    }
  }
  return control.col(0);
}

Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, 3> hodograph(
    const BezierSegment& segment) {
  const int degree = segment.degree();
  return degree * (segment.control.rightCols(degree) - segment.control.leftCols(degree));
}

Eigen::Vector2d start_direction(const BezierSegment& segment) {
  for (int i = 1; i <= segment.degree(); ++i) {
    const Eigen::Vector2d step = segment.control.col(i) - segment.control.col(0);
    if (!step.isZero(0)) return step.stableNormalized();
  }
  return Eigen::Vector2d::Zero();
}

Eigen::Vector2d end_direction(const BezierSegment& segment) {
  return -start_direction(reversed(segment));
}

BezierSegment reversed(const BezierSegment& segment) {
  return {segment.control.rowwise().reverse()};
}

Subpath reversed(const Subpath& subpath) {
  Subpath result;
  result.closed = subpath.closed;
  for (auto segment = subpath.segments.rbegin(); segment != subpath.segments.rend(); ++segment) {
    result.segments.push_back(reversed(*segment));
  }
  return result;
}

}  // namespace wavecurve
