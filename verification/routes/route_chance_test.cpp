#include "verification/routes/route_chance.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

TEST(RouteChance, IsTheBinomialTail) {
  const std::vector<double> halves(10, 0.5);
  EXPECT_DOUBLE_EQ(chance_of_at_least(10, halves), std::pow(0.5, 10));
  EXPECT_DOUBLE_EQ(chance_of_at_least(9, halves), 11 * std::pow(0.5, 10));
  EXPECT_DOUBLE_EQ(chance_of_at_least(0, halves), 1);
  const std::vector<double> mixed{0.5, 0.25, 1};
  EXPECT_DOUBLE_EQ(chance_of_at_least(3, mixed), 0.125);
  EXPECT_DOUBLE_EQ(chance_of_at_least(2, mixed), 0.125 + 0.375 + 0.125);
  EXPECT_EQ(chance_of_at_least(40, std::vector<double>(40, 1e-10)), least_chance);
  EXPECT_EQ(chance_of_at_least(3, std::vector<double>{1, 1, 1, 0.1}), 1);
  EXPECT_NEAR(chance_of_at_least(3, std::vector<double>{1, 1, 0.5, 0.1}), 0.55, 1e-15);
  EXPECT_EQ(chance_of_at_least(5, std::vector<double>{1, 1, 0.5, 0.1}), least_chance);
}

TEST(RouteChance, IsAnUpperBoundForVeryManyEvents) {
  // 2,000 events are summed, twice as many bounded: that twice as many happen of both halves is at
  // least as probable as that each half has its share.
  for (const int happened : {600, 650, 700, 900, 1900}) {
    const double summed = chance_of_at_least(happened, std::vector<double>(2000, 0.3));
    const double bounded = chance_of_at_least(2 * happened, std::vector<double>(4000, 0.3));
    if (happened <= 600) {
      EXPECT_EQ(bounded, 1);
    } else {
      EXPECT_GE(bounded, std::max(summed * summed, least_chance));
      EXPECT_LE(bounded, std::max(summed, least_chance));
    }
  }
}

TEST(RouteChance, IsForAnEntryOneInTheWidthOfItsError) {
  // Twice the median is 4 units; the first is farther away, the last exactly right.
  const std::vector<EntryError> entries{{50, 1e-9, 0, 1}, {2, 1e-9, 0, 1}, {0.5, 1e-9, 0, 1},
                                        {3, 1e-9, 1, 1},  {1, 1e-9, 0, 1}, {0, 1e-9, 0, 1}};
  const std::vector<double> chances = chance_of_each(entries);
  EXPECT_DOUBLE_EQ(chances[0], 0.01);
  EXPECT_DOUBLE_EQ(chances[1], 1.0 / 8);
  EXPECT_DOUBLE_EQ(chances[2], 1.0 / 8);
  EXPECT_DOUBLE_EQ(chances[3], 3.0 / 8);
  EXPECT_DOUBLE_EQ(chances[4], 1.0 / 8);
  EXPECT_DOUBLE_EQ(chances[5], 1);
}

TEST(RouteChance, TakesTheFinestMeasureOfAccuracy) {
  // One print has three decimals more: what is typical in last units says too much about the rest.
  const std::vector<EntryError> mixed{
      {2, 1e-6, 0, 1}, {2, 1e-6, 0, 1}, {0.25, 1e-6, 0, 1}, {2, 1e-9, 0, 1}, {1, 1e-9, 0, 1}};
  EXPECT_DOUBLE_EQ(chance_of_each(mixed)[2], 1.0);
  // Errors as large as the entries: that the small ones are accurate is no accident.
  const std::vector<EntryError> relative{{100, 1e-9, 0, 1},
                                         {100, 1e-9, 0, 1},
                                         {90, 1e-9, 0, 1},
                                         {0.2, 1e-9, 0, 1e-3},
                                         {0.1, 1e-9, 0, 1e-3}};
  EXPECT_DOUBLE_EQ(chance_of_each(relative)[3], 1.0);
  EXPECT_DOUBLE_EQ(chance_of_each(relative)[0], 1.0 / 360);
}

TEST(RouteChance, CountsTheWaysToChoose) {
  EXPECT_EQ(ways_to_choose(10, 1), 10);
  EXPECT_EQ(ways_to_choose(37, 37), 1);
  EXPECT_EQ(ways_to_choose(52, 5), 2598960);
}

}  // namespace
}  // namespace wavecurve::verification
