#include "wavecurve/io/drawings/detail/svg/arc.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"

namespace wavecurve::io {
namespace {

using Eigen::Vector2d;
constexpr double pi = std::numbers::pi;

/// How far a segment of a unit circle around the origin gets away from it, outwards and inwards.
std::pair<double, double> deviation(const BezierSegment& segment) {
  double out = 0, in = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double excess = test::point_at(segment, i / 1000.0).norm() - 1;
    out = std::max(out, excess);
    in = std::min(in, excess);
  }
  return {out, in};
}

TEST(Arc, TheCubicIsOutsideOfTheCircleByTheStatedBound) {
  const double quarter_of_step = pi / 24 / 4;
  const double bound =
      2.0 / 27 * std::pow(std::sin(quarter_of_step), 6) / std::pow(std::cos(quarter_of_step), 2);
  EXPECT_LT(bound, 1e-10);
  PathBuilder path;
  path.move_to({1, 0});
  append_arc(path, {{0, 0}, {1, 1}}, 0, 2 * pi);
  const auto circle = path.take();
  EXPECT_EQ(circle.at(0).segments.size(), 48U);
  for (const BezierSegment& segment : circle[0].segments) {
    const auto [out, in] = deviation(segment);
    // The bound is reached, and rounding adds a few units of 2^-53.
    EXPECT_LT(out, bound + 1e-15);
    EXPECT_GT(out, 0.99 * bound);
    EXPECT_GT(in, -1e-15);
  }
}

TEST(Arc, ACoarseStepShowsTheSameLaw) {
  // One quarter of the circle in one cubic, by the same control points: the bound as derived.
  BezierSegment quarter;
  const double k = 4.0 / 3 * std::tan(pi / 8);
  quarter.control.resize(2, 4);
  quarter.control << 1, 1, k, 0, 0, k, 1, 1;
  const double bound = 4.0 / 27 * std::pow(std::sin(pi / 8), 6) / std::pow(std::cos(pi / 8), 2);
  const double out = deviation(quarter).first;
  // The samples, 1e-3 apart, miss the largest value by a few times 1e-6 of it.
  EXPECT_NEAR((out + 1) * (out + 1) - 1, bound, 1e-5 * bound);
}

RC_GTEST_PROP(Arc, AnArcStartsAndEndsWhereItShouldAndLiesOnItsEllipse, ()) {
  const auto number = [](int from, int to) { return *rc::gen::inRange(from, to) / 16.0; };
  const Ellipse ellipse{
      {number(-320, 320), number(-320, 320)}, {number(1, 320), number(1, 320)}, number(-50, 50)};
  const double begin = number(-50, 50), sweep = number(-90, 90);
  RC_PRE(std::abs(sweep) > 0.1 && std::abs(sweep) < 2 * pi - 0.1);
  PathBuilder path;
  path.move_to(ellipse.at(begin));
  const Vector2d to = ellipse.at(begin + sweep);
  const double degrees = ellipse.rotation * 180 / pi;
  append_endpoint_arc(path, ellipse.radii, degrees, std::abs(sweep) > pi, sweep > 0, to);
  RC_ASSERT(path.current() == to);
  const auto arc = path.take();
  const Eigen::Rotation2Dd back(-ellipse.rotation);
  // The centre follows from the ends with an error of at most rounding by the sine of half the
  // sweep, and by the ratio of the radii (here up to 320), or by its root near a diameter.
  for (const BezierSegment& segment : arc.at(0).segments) {
    for (double s : {0.0, 0.3, 0.8}) {
      const Vector2d unit =
          (back * (test::point_at(segment, s) - ellipse.centre)).cwiseQuotient(ellipse.radii);
      RC_ASSERT(std::abs(unit.norm() - 1) < 1e-6);
    }
  }
  const Vector2d middle = test::point_at(arc[0].segments[arc[0].segments.size() / 2], 0);
  const Vector2d unit = (back * (middle - ellipse.centre)).cwiseQuotient(ellipse.radii);
  const double share =
      static_cast<double>(arc[0].segments.size() / 2) / static_cast<double>(arc[0].segments.size());
  const Vector2d expected(std::cos(begin + share * sweep), std::sin(begin + share * sweep));
  RC_ASSERT((unit - expected).norm() < 1e-6);
}

TEST(Arc, SmallRadiiGrowToReachTheEnd) {
  const auto path = test::path_of("M10 50A1 1 0 0 1 30 50");  // a half circle of radius 10
  for (const BezierSegment& segment : path.at(0).segments) {
    const Vector2d at = test::point_at(segment, 0.5);
    EXPECT_NEAR((at - Vector2d(20, 50)).norm(), 10, 1e-8);
    EXPECT_LT(at.y(), 50);  // clockwise, as seen, from the left end to the right one: above
  }
}

TEST(Arc, AnExactHalfCircleKeepsItsCentre) {
  const auto path = test::path_of("M10 50A10 10 0 1 0 30 50");
  for (const BezierSegment& segment : path.at(0).segments) {
    EXPECT_NEAR((test::point_at(segment, 0.5) - Vector2d(20, 50)).norm(), 10, 1.1e-9);
  }
}

TEST(Arc, RadiiOfZeroGiveALine) {
  const auto path = test::path_of("M10 50A0 5 0 0 1 30 50");
  ASSERT_EQ(path.at(0).segments.size(), 1U);
  EXPECT_EQ(path[0].segments[0].degree(), 1);
}

TEST(Arc, FlagsMayStandWithoutSpace) {
  const auto spaced = test::path_of("M10 50a9 5 20 0 1 10 4.5");
  const auto tight = test::path_of("M10 50a9 5 20 0110 4.5");
  ASSERT_EQ(spaced.at(0).segments.size(), tight.at(0).segments.size());
  EXPECT_EQ(spaced[0].segments.back().control, tight[0].segments.back().control);
}

}  // namespace
}  // namespace wavecurve::io
