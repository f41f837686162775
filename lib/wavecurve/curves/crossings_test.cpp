#include "wavecurve/curves/crossings.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve {
namespace {

using Eigen::Index;

Contour contour(std::initializer_list<std::pair<double, double>> points) {
  Contour result(static_cast<Index>(points.size()), 2);
  Index i = 0;
  for (const auto& [x, y] : points) result.row(i++) << x, y;
  return result;
}

/// n points of a polygon that steps over `step` vertices of a regular one: {n/step} crosses itself
/// n (step - 1) times, for odd n.
Contour star_polygon(int n, int step) {
  Contour points(n, 2);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i * step / n;
    points.row(i) << std::cos(angle), std::sin(angle);
  }
  return points;
}

TEST(CountCrossings, KnowsStarPolygons) {
  EXPECT_EQ(count_crossings(star_polygon(5, 1)), 0);
  EXPECT_EQ(count_crossings(star_polygon(5, 2)), 5);
  EXPECT_EQ(count_crossings(star_polygon(7, 3)), 14);
  EXPECT_EQ(count_crossings(star_polygon(101, 50)), 101 * 49);
}

TEST(CountCrossings, CountsOnlyProperOnes) {
  // A vertex on an edge; two loops with a common vertex; an edge run over twice.
  EXPECT_EQ(count_crossings(contour({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})), 0);
  EXPECT_EQ(count_crossings(contour({{0, 0}, {1, 1}, {1, -1}, {0, 0}, {-1, 1}, {-1, -1}})), 0);
  EXPECT_EQ(count_crossings(contour({{0, 0}, {4, 0}, {2, 0}, {1, 0}})), 0);
  EXPECT_EQ(count_crossings(contour({{0, 0}, {4, 0}, {0, 3}, {4, 3}})), 1);
  EXPECT_EQ(count_crossings(contour({{0, 0}, {4, 0}, {0, 3}, {4, 3}}), Closing::open), 0);
}

TEST(CountCrossings, TakesShortContours) {
  EXPECT_EQ(count_crossings(Contour(0, 2)), 0);
  EXPECT_EQ(count_crossings(contour({{1, 2}})), 0);
  EXPECT_EQ(count_crossings(contour({{1, 2}, {3, 4}})), 0);
  EXPECT_EQ(count_crossings(Contour(0, 2), contour({{1, 2}})), 0);
}

TEST(CountCrossings, BetweenContoursAndOfAnOutline) {
  const Contour square = contour({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const Contour inside = contour({{1, 1}, {1, 2}, {2, 2}});
  const Contour across = contour({{3, 1}, {3, 2}, {5, 1.5}});
  EXPECT_EQ(count_crossings(square, inside), 0);
  EXPECT_EQ(count_crossings(square, across), 2);
  const Contour star = star_polygon(5, 2).rowwise() + Eigen::RowVector2d(20, 0);
  EXPECT_EQ(count_crossings(std::vector<Contour>{square, across, inside, star}), 2 + 5);
}

TEST(CountCrossings, RefusesWhatIsNotFinite) {
  Contour points = star_polygon(5, 1);
  points(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(count_crossings(points), std::domain_error);
}

/// Points of a coarse grid, so that edges touch, overlap and repeat.
Contour grid_points(int max_size) {
  const int size = *rc::gen::inRange(0, max_size);
  Contour points(size, 2);
  for (Index i = 0; i < size; ++i)
    points.row(i) << *rc::gen::inRange(0, 9), *rc::gen::inRange(0, 9);
  return points;
}

RC_GTEST_PROP(CountCrossings, EqualsThePlainTwin, ()) {
  const Contour a = grid_points(60), b = grid_points(30);
  RC_ASSERT(count_crossings(a) == plain::count_crossings(a));
  RC_ASSERT(count_crossings(a, Closing::open) == plain::count_crossings(a, Closing::open));
  RC_ASSERT(count_crossings(a, b) == plain::count_crossings(a, b));
  // Off the grid, degenerate only where a triple of points happened to be.
  const Contour turned = a * Eigen::Rotation2Dd(0.3).toRotationMatrix();
  RC_ASSERT(count_crossings(turned) == plain::count_crossings(turned));
}

}  // namespace
}  // namespace wavecurve
