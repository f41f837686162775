#include "wavecurve/motion/ease.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::motion {
namespace {

constexpr Ease all[] = {Ease::linear, Ease::in, Ease::out, Ease::in_out};

/// One point that moves from 0 to 8 in 2 seconds.
Animation moving_point() {
  Contour start = Contour::Zero(1, 2), end = Contour::Constant(1, 2, 8);
  return {{0, 0, 8, 8}, 2, {{"point", {{0, {start}}, {2, {end}}}, {{0, {}}}}}};
}

TEST(Eased, RestsWhereItSays) {
  const double h = 1e-6;
  for (const Ease ease : all) {
    EXPECT_EQ(eased(ease, 0), 0);
    EXPECT_EQ(eased(ease, 1), 1);
    const bool starts_at_rest = ease == Ease::in || ease == Ease::in_out;
    const bool ends_at_rest = ease == Ease::out || ease == Ease::in_out;
    EXPECT_EQ(eased(ease, h) / h < 0.5, starts_at_rest);
    EXPECT_EQ((1 - eased(ease, 1 - h)) / h < 0.5, ends_at_rest);
    for (int i = 0; i < 20; ++i) EXPECT_LT(eased(ease, i / 20.0), eased(ease, (i + 1) / 20.0));
  }
}

TEST(Eased, FramesAreThoseOfTheWarpedTime) {
  for (const Ease ease : all) {
    const Animation animation = eased(moving_point(), ease, 9);
    for (int i = 0; i < 9; ++i) {
      const double x = frame_at(animation, 2 * i / 8.0)[0].contours[0](0, 0);
      EXPECT_NEAR(x, 8 * eased(ease, i / 8.0), 1e-14);
    }
  }
  EXPECT_EQ(eased(moving_point(), Ease::linear, 9).layers[0].outline.size(), 2u);
  EXPECT_THROW(eased(moving_point(), Ease::in, 1), std::invalid_argument);
}

TEST(Eased, OrdersComeWhenTheirTimeHasCome) {
  Animation animation = moving_point();
  animation.layers.push_back(animation.layers[0]);
  animation.order = {{animation.duration / 2, {1, 0}}};
  const Animation late = eased(animation, Ease::in, 9);
  ASSERT_EQ(late.order.size(), 1u);
  // The square of 6/8 is the first above a half.
  EXPECT_EQ(late.order[0].time, animation.duration * 6 / 8);
}

}  // namespace
}  // namespace wavecurve::motion
