#include "wavecurve/motion/morph/detail/covered_intervals.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::motion {
namespace {

Contour rectangle(double x, double y, double width, double height) {
  Contour points(4, 2);
  points << x, y, x + width, y, x + width, y + height, x, y + height;
  return points;
}

FrameLayer layer(const std::vector<Contour>& contours) {
  FrameLayer result{"", contours, {}};
  result.paint.fill = Colour{};
  return result;
}

// Corners on a coarse grid, so that edges often lie on each other.
RC_GTEST_PROP(ShareArea, RectanglesDoAsTheirSidesSay, ()) {
  const auto any = [] { return *rc::gen::inRange(0, 6); };
  const auto size = [] { return *rc::gen::inRange(1, 4); };
  const int x = any(), y = any(), w = size(), h = size();
  const int u = any(), v = any(), r = size(), s = size();
  const bool expected = x < u + r && u < x + w && y < v + s && v < y + h;
  const FrameLayer a = layer({rectangle(x, y, w, h)});
  FrameLayer b = layer({rectangle(u, v, r, s)});
  RC_ASSERT(share_area(a, b) == expected);
  b.contours[0] = b.contours[0].colwise().reverse().eval();
  RC_ASSERT(share_area(b, a) == expected);
}

TEST(ShareArea, AHoleIsNoArea) {
  const std::vector<Contour> frame{rectangle(0, 0, 9, 9),
                                   rectangle(2, 2, 5, 5).colwise().reverse()};
  EXPECT_FALSE(share_area(layer(frame), layer({rectangle(2, 2, 5, 5)})));
  EXPECT_TRUE(share_area(layer(frame), layer({rectangle(2, 2, 5, 5.5)})));
  FrameLayer twice = layer({rectangle(0, 0, 9, 9), rectangle(2, 2, 5, 5)});
  EXPECT_TRUE(share_area(twice, layer({rectangle(3, 3, 1, 1)})));
  twice.paint.fill_rule = FillRule::evenodd;
  EXPECT_FALSE(share_area(twice, layer({rectangle(3, 3, 1, 1)})));
}

TEST(ShareArea, WhatHasNoAreaSharesNone) {
  EXPECT_FALSE(share_area(layer({}), layer({rectangle(0, 0, 1, 1)})));
  EXPECT_FALSE(share_area(layer({rectangle(0, 0, 1, 0)}), layer({rectangle(0, 0, 1, 1)})));
}

// The middles of lines against the definition of what is inside.
TEST(CoveredIntervals, AreFillsByTheirRuleAndStrokesByTheirWidth) {
  FrameLayer twice = layer({rectangle(0, 0, 9, 9), rectangle(2, 2, 5, 5)});
  twice.paint.fill = Colour{};
  const ViewBox box{0, 0, 9, 9};
  using Line = std::vector<std::pair<double, double>>;
  EXPECT_EQ(covered_intervals(twice, box, 9).at(4), (Line{{0, 9}}));
  twice.paint.fill_rule = FillRule::evenodd;
  EXPECT_EQ(covered_intervals(twice, box, 9).at(4), (Line{{0, 2}, {7, 9}}));
  EXPECT_EQ(covered_intervals(twice, box, 9).at(1), (Line{{0, 9}}));
  twice.paint.fill.reset();
  twice.paint.stroke = Colour{};
  EXPECT_EQ(covered_intervals(twice, box, 9).at(4),
            (Line{{-0.5, 0.5}, {1.5, 2.5}, {6.5, 7.5}, {8.5, 9.5}}));
  EXPECT_EQ(shared_length({{{0, 2}, {5, 9}}}, {{{1, 6}, {8, 10}}}), 1 + 1 + 1);
}

}  // namespace
}  // namespace wavecurve::motion
