#include "wavecurve/io/animations/detail/painting_slots.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace wavecurve::io {
namespace {

using Order = std::vector<std::size_t>;

motion::Animation with_orders(std::size_t layers, const std::vector<Order>& orders) {
  motion::Animation animation;
  animation.layers.resize(layers);
  double time = 0;
  for (const Order& order : orders) animation.order.push_back({++time, order});
  return animation;
}

/// The layers of the slots that are shown in order k.
Order shown(const std::vector<PaintingSlot>& slots, std::size_t k) {
  Order layers;
  for (const PaintingSlot& slot : slots) {
    if (slot.is_shown[k]) layers.push_back(slot.layer);
  }
  return layers;
}

TEST(PaintingSlots, OneALayerWhereNothingIsExchanged) {
  const auto slots = painting_slots(with_orders(3, {}));
  EXPECT_EQ(slots.size(), 3U);
  EXPECT_TRUE(slots[1].is_always_shown());
}

TEST(PaintingSlots, HideWhatAnOrderLeavesOut) {
  motion::Animation chain = with_orders(4, {{0, 1}, {1, 0}, {2, 3}});
  chain.order[0].time = 0;
  const auto slots = painting_slots(chain);
  EXPECT_EQ(slots.size(), 5U);
  EXPECT_EQ(shown(slots, 0), (Order{0, 1}));
  EXPECT_EQ(shown(slots, 1), (Order{0, 1}));
  EXPECT_EQ(shown(slots, 2), (Order{1, 0}));
  EXPECT_EQ(shown(slots, 3), (Order{2, 3}));
}

TEST(PaintingSlots, OnlyWhatMovesHasTwo) {
  const auto slots = painting_slots(with_orders(4, {{3, 0, 1, 2}, {0, 1, 2, 3}}));
  ASSERT_EQ(slots.size(), 5U);  // and back again needs no third
  EXPECT_EQ(std::count_if(slots.begin(), slots.end(),
                          [](const PaintingSlot& slot) { return slot.is_always_shown(); }),
            3);
}

TEST(PaintingSlots, ShowEveryOrder) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    Order order(1 + random() % 9);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<Order> orders;
    for (std::size_t k = random() % 5; k > 0; --k) {
      std::shuffle(order.begin(), order.end(), random);
      orders.push_back(order);
    }
    const auto slots = painting_slots(with_orders(order.size(), orders));
    for (std::size_t k = 0; k < orders.size(); ++k) EXPECT_EQ(shown(slots, k + 1), orders[k]);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(shown(slots, 0), order);
  }
}

}  // namespace
}  // namespace wavecurve::io
