#include "wavecurve/curves/signed_area.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include "wavecurve/curves/detail/bezier.hpp"

namespace wavecurve {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Half the integral of B x B' about the origin given: of degree 5 at most, which Gauss-Legendre
/// quadrature with 7 points integrates exactly.
double swept_area(const BezierSegment& segment, const Eigen::Vector2d& origin) {
  const auto derivative = hodograph(segment);
  const auto integrand = [&](double s) {
    Eigen::Vector2d velocity = derivative.col(0);
    if (derivative.cols() == 2) velocity = (1 - s) * derivative.col(0) + s * derivative.col(1);
    if (derivative.cols() == 3) {
      velocity = (1 - s) * (1 - s) * derivative.col(0) + 2 * s * (1 - s) * derivative.col(1) +
                 s * s * derivative.col(2);
    }
    return cross(bezier_point(segment, s) - origin, velocity) / 2;
  };
  return boost::math::quadrature::gauss<double, 7>::integrate(integrand, 0.0, 1.0);
}

}  // namespace

double signed_area(const Contour& contour) {
  const Eigen::Index count = contour.rows();
  double area = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector2d from = contour.row(i) - contour.row(0);
    area += cross(from, contour.row((i + 1) % count) - contour.row(0)) / 2;
  }
  return area;
}

double signed_area(const Subpath& subpath) {
  if (subpath.segments.empty()) return 0;
  // About the start, the closing line of an open subpath sweeps no area.
  const Eigen::Vector2d origin = subpath.segments.front().control.col(0);
  double area = 0;
  for (const BezierSegment& segment : subpath.segments) area += swept_area(segment, origin);
  return area;
}

}  // namespace wavecurve
