#include "wavecurve/io/drawings/detail/svg/region.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::io {
namespace {

Contour rectangle(double x, double y, double width, double height) {
  Contour polygon(4, 2);
  polygon << x, y, x + width, y, x + width, y + height, x, y + height;
  return polygon;
}

/// Any polygon, which may cross itself.
Contour any_polygon() {
  Contour polygon(*rc::gen::inRange(3, 12), 2);
  for (double& value : polygon.reshaped()) value = *rc::gen::inRange(-100000, 100000) / 1000.0;
  return polygon;
}

/// How often polygons wind about a point: by the edges that a ray to the right meets.
int winding(const std::vector<Contour>& polygons, double x, double y) {
  int count = 0;
  for (const Contour& polygon : polygons) {
    for (Eigen::Index i = 0, n = polygon.rows(); i < n; ++i) {
      const auto from = polygon.row(i), to = polygon.row((i + 1) % n);
      if ((from.y() <= y) == (to.y() <= y)) continue;
      const double at = from.x() + (y - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
      if (at > x) count += to.y() > from.y() ? 1 : -1;
    }
  }
  return count;
}

RC_GTEST_PROP(Region, HoldsThePointsThatItsDefinitionSays, ()) {
  const std::vector<Contour> one{any_polygon(), any_polygon()}, two{any_polygon()};
  const Region a = region_of(one, FillRule::evenodd), b = region_of(two, FillRule::nonzero);
  const Region both = intersected(a, b), any = united(a, b);
  for (int i = 0; i < 20; ++i) {
    // Between the places where corners may be.
    const double x = *rc::gen::inRange(-100000, 100000) / 1000.0 + 0.0005;
    const double y = *rc::gen::inRange(-100000, 100000) / 1000.0 + 0.0005;
    const bool in_one = winding(one, x, y) % 2 != 0, in_two = winding(two, x, y) != 0;
    RC_ASSERT((winding(a.polygons, x, y) != 0) == in_one);
    RC_ASSERT((winding(b.polygons, x, y) != 0) == in_two);
    RC_ASSERT((winding(both.polygons, x, y) != 0) == (in_one && in_two));
    RC_ASSERT((winding(any.polygons, x, y) != 0) == (in_one || in_two));
  }
  // Whole numbers of the grid: 2^-45 of 100, along edges of a length of a few thousand in all.
  RC_ASSERT(std::abs(both.area() + any.area() - a.area() - b.area()) < 1e-8);
}

TEST(Region, ShortDecimalsStayWhatTheyAre) {
  const Region part = intersected({{rectangle(0, 0, 24, 24)}}, {{rectangle(12.5, 3.125, 100, 7)}});
  ASSERT_EQ(part.polygons.size(), 1U);
  EXPECT_EQ(part.polygons[0].rows(), 4);
  EXPECT_EQ(part.area(), 11.5 * 7);
  EXPECT_EQ(part.polygons[0].colwise().minCoeff(), Eigen::RowVector2d(12.5, 3.125));
  EXPECT_EQ(part.polygons[0].colwise().maxCoeff(), Eigen::RowVector2d(24, 10.125));
}

TEST(Region, AHoleTurnsTheOtherWay) {
  const Region frame =
      region_of({rectangle(0, 0, 10, 10), rectangle(2, 2, 6, 6)}, FillRule::evenodd);
  EXPECT_EQ(frame.area(), 64);
  const std::vector<Subpath> outline = outline_of(frame);
  ASSERT_EQ(outline.size(), 2U);
  EXPECT_TRUE(outline[0].closed && outline[1].closed);
  EXPECT_EQ(region_of(polygons_of(outline, 1), FillRule::nonzero).area(), 64);
  EXPECT_EQ(region_of(polygons_of(outline, 1), FillRule::evenodd).area(), 64);
  EXPECT_EQ(united(frame, {}).area(), 64);
  EXPECT_TRUE(intersected(frame, {}).polygons.empty());
}

RC_GTEST_PROP(Region, PolygonsAreWithinTheTolerance, ()) {
  BezierSegment curve;
  curve.control.resize(2, *rc::gen::inRange(2, 5));
  for (double& value : curve.control.reshaped()) value = *rc::gen::inRange(-100, 100);
  const double tolerance = std::pow(10.0, *rc::gen::inRange(-3, 1));
  // The chord of a part of the parameter, 1/n, is off by |B''| / (8 n^2) at most; second differences are 400 at most.
  const double degree = curve.degree();
  const double reached =
      degree * (degree - 1) * 400 * std::numbers::sqrt2 / (8.0 * most_pieces * most_pieces);
  const Contour polygon = polygons_of({{{curve}, false}}, tolerance).front();
  for (int i = 0; i <= 50; ++i) {
    Eigen::MatrixXd points = curve.control;
    for (Eigen::Index n = points.cols() - 1; n > 0; --n) {
      points = ((1 - i / 50.0) * points.leftCols(n) + i / 50.0 * points.rightCols(n)).eval();
    }
    const Eigen::RowVector2d point = points.col(0).transpose();
    double nearest = INFINITY;
    for (Eigen::Index k = 0; k + 1 < polygon.rows(); ++k) {
      const Eigen::RowVector2d from = polygon.row(k), way = polygon.row(k + 1) - from;
      const double length = way.squaredNorm();
      const double s = length > 0 ? std::clamp((point - from).dot(way) / length, 0.0, 1.0) : 0;
      nearest = std::min(nearest, (from + s * way - point).norm());
    }
    RC_ASSERT(nearest <= std::max(tolerance, reached) * (1 + 1e-9) + 1e-12);
  }
}

TEST(Region, TheWorkIsBoundedByEdgesTimesRuns) {
  EXPECT_EQ(most_crossings({rectangle(0, 0, 1, 1)}), 4U * 2);
  EXPECT_EQ(most_crossings({rectangle(0, 0, 1, 1), rectangle(0, 0, 1, 1)}), 8U * 4);
}

}  // namespace
}  // namespace wavecurve::io
