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

FrameLayer filled(std::vector<Contour> contours) {
  FrameLayer layer{"", std::move(contours), {}};
  layer.paint.fill = Colour{};
  return layer;
}

FrameLayer stroked(std::vector<Contour> contours, std::vector<bool> open, LineCap cap) {
  FrameLayer layer{"", std::move(contours), {}, std::move(open)};
  layer.paint.stroke = Colour{};
  layer.paint.line_cap = cap;
  layer.paint.line_join = LineJoin::round;
  return layer;
}

TEST(PairContours, OuterWithOuterAndHoleWithHole) {
  // The hole of the source is as large as the second piece of the destination, and at its place.
  const ContourPairs pairs = pair_contours(
      filled({circle(0, 0, 9), circle(3, 0, 2, false)}),
      filled({circle(3, 0, 2), circle(0, 0, 9), circle(-3, 0, 1, false)}), Rotation::kept, {});
  ASSERT_EQ(pairs.lasting.size(), 2u);
  EXPECT_GT(signed_area(pairs.lasting[0].source), 200);
  EXPECT_GT(signed_area(pairs.lasting[0].destination), 200);
  EXPECT_LT(signed_area(pairs.lasting[1].source), 0);
  EXPECT_LT(signed_area(pairs.lasting[1].destination), 0);
  // The piece grows from a point inside the source.
  ASSERT_EQ(pairs.appearing.size(), 1u);
  EXPECT_EQ(signed_area(pairs.appearing[0].source), 0);
  EXPECT_NE(winding_number(circle(0, 0, 9), pairs.appearing[0].source.row(0)), 0);
  EXPECT_NEAR(pairs.appearing[0].source(0, 0), 3, 1e-12);
  EXPECT_TRUE(pairs.vanishing.empty());
}

TEST(PairContours, WhatIsOutsideShrinksIntoTheNearest) {
  const ContourPairs pairs = pair_contours(filled({circle(0, 0, 1), circle(20, 0, 1)}),
                                           filled({circle(0, 1, 1)}), Rotation::kept, {});
  ASSERT_EQ(pairs.lasting.size(), 1u);
  ASSERT_EQ(pairs.vanishing.size(), 1u);
  const Contour& point = pairs.vanishing[0].destination;
  EXPECT_NE(winding_number(circle(0, 1, 1), point.row(0)), 0);
  EXPECT_EQ((point.rowwise() - point.row(0)).norm(), 0);
}

TEST(PairContours, StartsWhereToldTo) {
  const Contour turned = started_at(circle(5, 5, 2), 11);
  const auto pair = [&](std::optional<Index> start) {
    return pair_contours(filled({circle(0, 0, 1)}), filled({turned}), Rotation::kept, start)
        .lasting.at(0);
  };
  EXPECT_LT((pair({}).destination - circle(5, 5, 2)).norm(), 1e-12);
  EXPECT_EQ(pair(4).destination, started_at(turned, 4));
}

TEST(PairContours, LinesGoByTheirEnds) {
  const ContourPairs pairs =
      pair_contours(stroked({line(0, 5, 0)}, {true}, LineCap::butt),
                    stroked({line(9, 3, 2)}, {true}, LineCap::butt), Rotation::kept, {});
  ASSERT_EQ(pairs.lasting.size(), 1u);
  EXPECT_TRUE(pairs.lasting[0].open);
  EXPECT_EQ(pairs.lasting[0].destination(0, 0), 3);  // its left end, as of the other
}

TEST(PairContours, ALineBecomesAClosedContourWhereItsJoinsLookLikeItsCaps) {
  const FrameLayer closed = stroked({circle(0, 0, 1)}, {false}, LineCap::butt);
  const auto pairs = [&](LineCap cap) {
    return pair_contours(stroked({line(0, 5, 0)}, {true}, cap), closed, Rotation::kept, {});
  };
  ASSERT_EQ(pairs(LineCap::round).lasting.size(), 1u);
  EXPECT_FALSE(pairs(LineCap::round).lasting[0].open);
  const ContourPairs apart = pairs(LineCap::square);
  EXPECT_TRUE(apart.lasting.empty());
  ASSERT_EQ(apart.vanishing.size(), 1u);
  EXPECT_TRUE(apart.vanishing[0].open);
  EXPECT_EQ(apart.appearing.size(), 1u);
}

TEST(ShrinkContours, ToOnePointWithTheirHoles) {
  const auto pairs =
      shrink_contours(filled({circle(0, 0, 3), circle(1, 0, 1, false)}), {circle(0, 5, 9)});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].destination, pairs[1].destination);
  EXPECT_EQ(reversed(pairs)[0].source, pairs[0].destination);
}

}  // namespace
}  // namespace wavecurve::motion
