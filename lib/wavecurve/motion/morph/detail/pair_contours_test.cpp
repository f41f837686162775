#include "wavecurve/motion/morph/detail/pair_contours.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/motion/morph/detail/nesting.hpp"

namespace wavecurve::motion {
namespace {

using Eigen::Index;

constexpr Index samples = 32;

Contour circle(double x, double y, double radius, bool clockwise = true) {
  Contour points(samples, 2);
  for (Index i = 0; i < samples; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / samples * (clockwise ? 1 : -1);
    points.row(i) << x + radius * std::cos(t), y + radius * std::sin(t);
  }
  return points;
}

Contour line(double x0, double x1, double y) {
  Contour points(samples, 2);
  for (Index i = 0; i < samples; ++i) {
    const double share = 1 - std::abs(1 - 2.0 * static_cast<double>(i) / samples);
    points.row(i) << std::lerp(x0, x1, share), y;
  }
  return points;
}

TEST(Oriented, OuterContoursClockwiseHolesNot) {
  const auto result = oriented({circle(0, 0, 3), circle(0, 0, 1)}, FillRule::evenodd);
  EXPECT_GT(signed_area(result[0]), 0);
  EXPECT_LT(signed_area(result[1]), 0);
  EXPECT_TRUE(is_hole(result, 1, FillRule::nonzero));
  EXPECT_EQ(result[1].row(0), circle(0, 0, 1).row(0));
  EXPECT_GT(signed_area(oriented({circle(0, 0, 3), circle(0, 0, 1)}, FillRule::nonzero)[1]), 0);
  EXPECT_GT(signed_area(oriented({circle(0, 0, 3), circle(0, 0, 1, false)}, std::nullopt)[1]), 0);
}

TEST(PairContours, OuterWithOuterAndHoleWithHole) {
  // The hole of the source is as large as the second piece of the destination, and at its place.
  const auto pairs = pair_contours({circle(0, 0, 9), circle(3, 0, 2, false)},
                                   {circle(3, 0, 2), circle(0, 0, 9), circle(-3, 0, 1, false)},
                                   Rotation::kept, std::nullopt);
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_GT(signed_area(pairs[0].source), 200);
  EXPECT_GT(signed_area(pairs[0].destination), 200);
  // The piece grows from a point inside the source.
  EXPECT_EQ(signed_area(pairs[1].source), 0);
  EXPECT_NE(winding_number(circle(0, 0, 9), pairs[1].source.row(0)), 0);
  EXPECT_NEAR(pairs[1].source(0, 0), 3, 1e-12);
  EXPECT_LT(signed_area(pairs[2].source), 0);
  EXPECT_LT(signed_area(pairs[2].destination), 0);
}

TEST(PairContours, WhatIsOutsideShrinksIntoTheNearest) {
  const auto pairs = pair_contours({circle(0, 0, 1), circle(20, 0, 1)}, {circle(0, 1, 1)},
                                   Rotation::kept, std::nullopt);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_NE(winding_number(circle(0, 1, 1), pairs[1].destination.row(0)), 0);
  EXPECT_EQ((pairs[1].destination.rowwise() - pairs[1].destination.row(0)).norm(), 0);
}

TEST(PairContours, StartsWhereToldTo) {
  const Contour turned = started_at(circle(5, 5, 2), 11);
  const auto found = pair_contours({circle(0, 0, 1)}, {turned}, Rotation::kept, std::nullopt);
  EXPECT_LT((found[0].destination - circle(5, 5, 2)).norm(), 1e-12);
  const auto told = pair_contours({circle(0, 0, 1)}, {turned}, Rotation::kept, 4);
  EXPECT_EQ(told[0].destination, started_at(turned, 4));
}

TEST(PairContours, StrokesStayThereAndBack) {
  ASSERT_TRUE(is_there_and_back(line(0, 5, 0)));
  ASSERT_FALSE(is_there_and_back(circle(0, 0, 1)));
  const auto pairs = pair_contours({line(0, 5, 0)}, {line(9, 3, 2)}, Rotation::kept, std::nullopt);
  EXPECT_TRUE(is_there_and_back(pairs[0].source + pairs[0].destination));
  EXPECT_EQ(pairs[0].destination(0, 0), 3);  // its left end, as of the other
}

TEST(ShrinkContours, ToOnePointWithTheirHoles) {
  const auto pairs = shrink_contours({circle(0, 0, 3), circle(1, 0, 1, false)}, {circle(0, 5, 9)});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].destination, pairs[1].destination);
  EXPECT_EQ(reversed(pairs)[0].source, pairs[0].destination);
}

}  // namespace
}  // namespace wavecurve::motion
