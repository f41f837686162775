#include "wavecurve/motion/morph/detail/nesting.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace wavecurve::motion {
namespace {

Contour square(double size, bool clockwise = true) {
  Contour points(4, 2);
  points << -1, -1, 1, -1, 1, 1, -1, 1;
  if (!clockwise) points = points.colwise().reverse().eval();
  return size * points;
}

TEST(WindingNumber, CountsTurnsClockwise) {
  EXPECT_EQ(winding_number(square(1), {0, 0}), 1);
  EXPECT_EQ(winding_number(square(1, false), {0.5, 0.25}), -1);
  EXPECT_EQ(winding_number(square(1), {2, 0}), 0);
  EXPECT_EQ(winding_number(square(1), {0, 1.5}), 0);
  Contour twice(8, 2);
  twice << square(1), square(2);
  EXPECT_EQ(winding_number(twice, {0, 0}), 2);
}

TEST(InteriorPoint, LiesInsideACrescent) {
  Contour crescent(64, 2);
  for (int i = 0; i < 32; ++i) {
    const double t = 1.5 * std::numbers::pi * i / 31;
    crescent.row(i) << std::cos(t), std::sin(t);
    crescent.row(63 - i) << 0.9 * std::cos(t), 0.9 * std::sin(t);
  }
  EXPECT_EQ(winding_number(crescent, crescent.colwise().mean()), 0);  // the mean does not
  EXPECT_EQ(std::abs(winding_number(crescent, interior_point(crescent))), 1);
  EXPECT_EQ(std::abs(winding_number(square(1, false), interior_point(square(1, false)))), 1);
}

TEST(InteriorPoint, LiesOnALine) {
  Contour line(4, 2);
  line << 0, 0, 1, 0, 2, 0, 1, 0;
  EXPECT_EQ(interior_point(line), Eigen::Vector2d(1, 0));
}

}  // namespace
}  // namespace wavecurve::motion
