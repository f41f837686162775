#include "wavecurve/motion/chain.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/motion/detail/check_animation.hpp"

namespace wavecurve::motion {
namespace {

Contour triangle(double x) { return (Contour(3, 2) << x, 0, x + 1, 0, x, 1).finished(); }

AnimatedLayer moving(const std::string& id, double from, double to, double duration) {
  return {id, {{0, {triangle(from)}}, {duration, {triangle(to)}}}, {{0, {}}, {duration, {}}}};
}

std::string ids(const std::vector<FrameLayer>& layers) {
  std::string text;
  for (const FrameLayer& layer : layers) text += layer.id + " ";
  return text;
}

/// Two layers that exchange their places half-way, then one.
std::vector<Animation> two_legs() {
  Animation first{{0, 0, 10, 10}, 2, {moving("a", 0, 4, 2), moving("b", 2, 6, 2)}};
  first.order = {{1, {1, 0}}};
  return {first, {{0, 0, 5, 5}, 3, {moving("a", 4, 1, 3)}}};
}

TEST(Chain, ShowsEachLegInItsTimeAlone) {
  const Animation whole = chain(two_legs());
  check_animation(whole);
  EXPECT_EQ(whole.duration, 5);
  EXPECT_EQ(whole.view_box, (ViewBox{0, 0, 10, 10}));
  EXPECT_EQ(ids(frame_at(whole, 0)), "a b ");
  EXPECT_EQ(ids(frame_at(whole, 1.5)), "b a ");
  EXPECT_EQ(ids(frame_at(whole, 2)), "a-2 ");
  EXPECT_EQ(ids(frame_at(whole, 5)), "a-2 ");
  EXPECT_EQ(frame_at(whole, 0.5)[0].contours[0], triangle(1));
  EXPECT_TRUE(frame_at(whole, 3)[0].contours[0].isApprox(triangle(3), 1e-12));
  EXPECT_EQ(frame_at(whole, 5)[0].contours[0], triangle(1));
}

TEST(Chain, AnOrderThatChangesAsALegEndsGivesWay) {
  std::vector<Animation> legs = two_legs();
  legs[0].order[0].time = 2;
  const Animation whole = chain(legs);
  check_animation(whole);
  EXPECT_EQ(ids(frame_at(whole, 1.9)), "a b ");
  EXPECT_EQ(ids(frame_at(whole, 2)), "a-2 ");
  EXPECT_THROW(chain({}), std::invalid_argument);
}

TEST(Fitted, FillsTheBoxAndScalesStrokes) {
  Layer layer{"l", {polygon((Contour(3, 2) << 0, 0, 10, 0, 10, 5).finished())}, {}};
  layer.paint.stroke_width = 2;
  const Drawing drawing{{0, 0, 10, 5}, {layer}};
  const Drawing result = fitted(drawing, {100, 0, 20, 20});
  EXPECT_EQ(result.view_box, (ViewBox{100, 0, 20, 20}));
  EXPECT_EQ(result.layers[0].paint.stroke_width, 4);
  const auto& control = result.layers[0].subpaths[0].segments[1].control;
  EXPECT_EQ(control.col(0), Eigen::Vector2d(120, 5));
  EXPECT_EQ(control.col(1), Eigen::Vector2d(120, 15));
}

}  // namespace
}  // namespace wavecurve::motion
