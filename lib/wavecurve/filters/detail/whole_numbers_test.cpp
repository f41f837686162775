#include "wavecurve/filters/detail/whole_numbers.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace wavecurve {
namespace {

TEST(WholeNumbers, HalvesAreRoundedDownOfBothSigns) {
  for (int n = -9; n <= 9; ++n) EXPECT_EQ(floor_half(n), std::floor(n / 2.0)) << n;
}

TEST(WholeNumbers, PowersOfTwoAreThoseThatAShiftOfOneMakes) {
  for (Eigen::Index n = -8; n <= 1025; ++n) {
    bool expected = false;
    for (int k = 0; k < 11; ++k) expected |= n == Eigen::Index{1} << k;
    EXPECT_EQ(is_power_of_two(n), expected) << n;
  }
}

TEST(WholeNumbers, LevelsEndAtAnOddNumber) {
  EXPECT_EQ(all_levels(1), 0);
  EXPECT_EQ(all_levels(1024), 10);
  EXPECT_EQ(all_levels(96), 5);
  EXPECT_EQ(all_levels(97), 0);
}

TEST(WholeNumbers, ALogarithmIsOfAPowerOfTwoUpToItsBound) {
  EXPECT_EQ(checked_log2(1), 0);
  EXPECT_EQ(checked_log2(Eigen::Index{1} << 24), 24);
  for (const Eigen::Index wrong : {Eigen::Index{-2}, Eigen::Index{0}, Eigen::Index{3},
                                   Eigen::Index{96}, Eigen::Index{1} << 25}) {
    try {
      checked_log2(wrong);
      ADD_FAILURE() << wrong;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), "samples is " + std::to_string(wrong) +
                                  ", but must be a power of two from 1 to 2^24");
    }
  }
}

}  // namespace
}  // namespace wavecurve
