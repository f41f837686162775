#include "wavecurve/motion/morph/detail/share_area.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::motion {
namespace {

Contour rectangle(double x, double y, double width, double height) {
  Contour points(4, 2);
  points << x, y, x + width, y, x + width, y + height, x, y + height;
  return points;
}

FrameLayer layer(const std::vector<Contour>& contours) { return {"", contours, {}}; }

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

}  // namespace
}  // namespace wavecurve::motion
