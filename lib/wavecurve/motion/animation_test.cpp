#include "wavecurve/motion/animation.hpp"

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/motion/detail/check_animation.hpp"
#include "wavecurve/motion/there_and_back.hpp"

namespace wavecurve::motion {
namespace {

Animation triangle() {
  const Contour a = (Contour(3, 2) << 0, 0, 4, 0, 0, 4).finished();
  Paint red, blue;
  red.fill = Colour{1, 0, 0};
  blue.fill = Colour{0, 0, 1};
  return {{0, 0, 10, 10}, 2, {{"triangle", {{0.5, {a}}, {2, {2 * a}}}, {{0, red}, {2, blue}}}}};
}

TEST(ThereAndBack, IsItsOwnMirror) {
  const Animation once = triangle(), both = there_and_back(once);
  check_animation(both);
  EXPECT_EQ(both.duration, 4);
  for (double time : {0.0, 0.25, 0.5, 1.0, 1.7, 2.0}) {
    const FrameLayer there = frame_at(both, time)[0], back = frame_at(both, 4 - time)[0];
    EXPECT_EQ(there.contours[0], frame_at(once, time)[0].contours[0]);
    EXPECT_TRUE(there.contours[0].isApprox(back.contours[0], 1e-15)) << time;
    EXPECT_NEAR(there.paint.fill->red, back.paint.fill->red, 1e-15) << time;
  }
}

/// Three layers of one point, a b c, then b a c, then c b a.
Animation exchanged() {
  Animation animation = triangle();
  animation.layers.resize(3, animation.layers[0]);
  for (std::size_t i = 0; i < 3; ++i) animation.layers[i].id = std::string(1, "abc"[i]);
  animation.order = {{0.5, {1, 0, 2}}, {1.5, {2, 1, 0}}};
  return animation;
}

std::string order_text(const Animation& animation, double time) {
  std::string text;
  for (const FrameLayer& layer : frame_at(animation, time)) text += layer.id;
  return text;
}

TEST(FrameAt, IsInThePaintingOrderOfItsTime) {
  const Animation animation = exchanged();
  EXPECT_EQ(order_text(animation, 0.49), "abc");
  EXPECT_EQ(order_text(animation, 0.5), "bac");
  EXPECT_EQ(order_text(animation, 2), "cba");
  const Animation both = there_and_back(animation);
  check_animation(both);
  for (const double time : {0.3, 1.0, 1.7}) {
    EXPECT_EQ(order_text(both, time), order_text(animation, time));
    EXPECT_EQ(order_text(both, 4 - time), order_text(animation, time));
  }
}

TEST(FrameAt, SwitchesCapsAndMixesMiterLimits) {
  Animation animation = triangle();
  animation.layers[0].paint[0].paint.line_cap = LineCap::square;
  animation.layers[0].paint[1].paint.miter_limit = 8;
  const Paint paint = frame_at(animation, 1)[0].paint;
  EXPECT_EQ(paint.line_cap, LineCap::square);
  EXPECT_EQ(paint.miter_limit, 6);
}

TEST(CheckAnimation, WantsOrdersOfItsLayers) {
  Animation some = exchanged();
  some.order[1].order = {2, 0};  // the others are not there
  check_animation(some);
  EXPECT_EQ(order_text(some, 2), "ca");
  for (const std::vector<std::size_t>& order :
       std::vector<std::vector<std::size_t>>{{0, 0}, {0, 1, 1}, {0, 1, 3}}) {
    Animation animation = exchanged();
    animation.order[1].order = order;
    EXPECT_THROW(check_animation(animation), std::invalid_argument);
  }
  Animation animation = exchanged();
  animation.order[1].time = 0.5;
  EXPECT_THROW(check_animation(animation), std::invalid_argument);
}

struct Defect {
  std::string message;
  std::function<void(Animation&)> cause;
};

TEST(CheckAnimation, NamesTheLayerAndTheDefect) {
  const Defect defects[] = {
      {"contour 0 has 3 points in key 0 and 4 in key 1",
       [](Animation& a) { a.layers[0].outline[1].contours[0] = Contour::Zero(4, 2); }},
      {"has 1 contours in key 0 and 2 in key 1",
       [](Animation& a) { a.layers[0].outline[1].contours.push_back(Contour::Zero(3, 2)); }},
      {"contour 0 has a point in key 1 that is not finite",
       [](Animation& a) { a.layers[0].outline[1].contours[0](2, 1) = 0.0 / 0.0; }},
      {"contour 0 has no points",
       [](Animation& a) { a.layers[0].outline[0].contours[0] = Contour(0, 2); }},
      {"outline key at 0.5 s follows one at 0.5 s",
       [](Animation& a) { a.layers[0].outline[1].time = 0.5; }},
      {"outline key at 3 s is outside 0 .. 2 s",
       [](Animation& a) { a.layers[0].outline[1].time = 3; }},
      {"has no paint key", [](Animation& a) { a.layers[0].paint.clear(); }},
      {"has a fill or a stroke in some keys only",
       [](Animation& a) { a.layers[0].paint[1].paint.fill.reset(); }},
      {"has a paint that is not finite",
       [](Animation& a) { a.layers[0].paint[1].paint.fill_opacity = 0.0 / 0.0; }}};
  check_animation(triangle());
  for (const Defect& defect : defects) {
    Animation animation = triangle();
    defect.cause(animation);
    try {
      check_animation(animation);
      ADD_FAILURE() << defect.message;
    } catch (const std::invalid_argument& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find("layer 'triangle'"), 0U) << message;
      EXPECT_NE(message.find(defect.message), std::string::npos) << message;
    }
  }
}

TEST(CheckAnimation, WantsAViewBoxAndADuration) {
  Animation animation = triangle();
  animation.view_box.width = 0;
  EXPECT_THROW(check_animation(animation), std::invalid_argument);
  animation = triangle();
  // A rate of frames of the second would be infinite.
  for (const double duration : {0.0, 1e-320, -1.0, std::nan(""), 1e300}) {
    animation.duration = duration;
    EXPECT_THROW(check_animation(animation), std::invalid_argument) << duration;
  }
}

}  // namespace
}  // namespace wavecurve::motion
