#include "wavecurve/elementary/root.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/elementary/units_test.hpp"

namespace wavecurve {
namespace {

using certified::Ball;

TEST(Root, IsRoundedToNearestButForAHundredth) {
  const certified::WorkingPrecision precision(200);
  for (int n = 2; n <= 16; ++n) {
    for (const double x : numbers_of_all_sizes(2000, -1074, 1024)) {
      const double size = std::abs(x);
      const Ball truth = exp(log(Ball::from_double(size)) / n);
      ASSERT_LE(units_from(root(size, n), truth), 0.51) << size << ' ' << n;
    }
  }
}

TEST(Root, IsExactForWholePowers) {
  for (int n = 2; n <= 16; ++n) {
    for (int i = 0; i < 8; ++i) EXPECT_EQ(root(whole_power(i, n), n), i) << i << ' ' << n;
  }
}

TEST(Root, FollowsTheStandardForSpecialValues) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(root(0, 5), 0);
  EXPECT_EQ(root(infinity, 5), infinity);
  EXPECT_EQ(root(-27, 3), -3);
  EXPECT_TRUE(std::isnan(root(-1, 2)) && std::isnan(root(std::nan(""), 3)));
  EXPECT_THROW(root(1, 1), std::invalid_argument);
  EXPECT_THROW(root(1, 17), std::invalid_argument);
}

TEST(PowerOfRootTwo, IsRoundedToNearest) {
  EXPECT_EQ(power_of_root_two(0), 1);
  EXPECT_EQ(power_of_root_two(-6), 1.0 / 8);
  for (int k = -9; k < 10; k += 2) {
    EXPECT_EQ(power_of_root_two(k), std::sqrt(std::ldexp(1.0, k))) << k;
  }
}

TEST(WholePower, IsAProduct) {
  EXPECT_EQ(whole_power(3, 0), 1);
  EXPECT_EQ(whole_power(3, 1), 3);
  EXPECT_EQ(whole_power(-3, 3), -27);
}

}  // namespace
}  // namespace wavecurve
