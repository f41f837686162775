#include "wavecurve/motion/morph/detail/exchange_times.hpp"

#include <gtest/gtest.h>

namespace wavecurve::motion {
namespace {

/// A square of side 2 that moves from one abscissa to another in 8 seconds.
AnimatedLayer square(double from, double to, Colour colour) {
  Contour points(4, 2);
  points << 0, 4, 2, 4, 2, 6, 0, 6;
  Paint paint;
  paint.fill = colour;
  return {"",
          {{0, {points.rowwise() + Eigen::RowVector2d(from, 0)}},
           {8, {points.rowwise() + Eigen::RowVector2d(to, 0)}}},
          {{0, paint}}};
}

Animation of(std::vector<AnimatedLayer> layers) { return {{0, 0, 10, 10}, 8, std::move(layers)}; }

TEST(ExchangeTimes, AreWhereTheLayersAreApart) {
  // They leave each other at 2 s and meet again at 7 s: the middle is as good as any between.
  const Animation animation = of({square(0, 8, {}), square(1, 1, {1, 1, 1})});
  EXPECT_TRUE(exchange_times(animation, {0, 1}).empty());
  const auto keys = exchange_times(animation, {1, 0});
  ASSERT_EQ(keys.size(), 1u);
  EXPECT_EQ(keys[0].time, 4);
  EXPECT_EQ(keys[0].order, (std::vector<std::size_t>{1, 0}));
  // Here they lie on each other until the end nears.
  const auto late = exchange_times(of({square(0, 2.2, {}), square(0, 0, {1, 1, 1})}), {1, 0});
  ASSERT_EQ(late.size(), 1u);
  EXPECT_EQ(late[0].time, 7);
}

TEST(ExchangeTimes, EachBlockHasItsOwn) {
  const Animation animation = of({square(0, 2.2, {}), square(0, 0, {1, 1, 1}),
                                  square(5, 5, {1, 0, 0}), square(7.2, 5, {0, 1, 0})});
  const auto keys = exchange_times(animation, {1, 0, 3, 2});
  ASSERT_EQ(keys.size(), 2u);
  EXPECT_EQ(keys[0].time, 1);
  EXPECT_EQ(keys[0].order, (std::vector<std::size_t>{0, 1, 3, 2}));
  EXPECT_EQ(keys[1].time, 7);
  EXPECT_EQ(keys[1].order, (std::vector<std::size_t>{1, 0, 3, 2}));
}

}  // namespace
}  // namespace wavecurve::motion
