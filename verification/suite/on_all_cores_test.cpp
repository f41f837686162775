#include "verification/suite/on_all_cores.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

TEST(OnAllCores, EachIsDoneOnceAndThenReported) {
  std::vector<std::atomic<int>> done(1000);
  std::vector<int> reported(1000);
  std::atomic<int> reporting = 0;
  on_all_cores(
      1000, [&](std::size_t i) { ++done[i]; },
      [&](std::size_t i) {
        EXPECT_EQ(++reporting, 1);
        EXPECT_EQ(done[i], 1);
        ++reported[i];
        --reporting;
      });
  EXPECT_EQ(reported, std::vector<int>(1000, 1));
  EXPECT_TRUE(std::all_of(done.begin(), done.end(), [](const auto& n) { return n == 1; }));
}

TEST(OnAllCores, WhatIsThrownEndsTheWork) {
  std::atomic<int> done = 0;
  const auto count = [&](std::size_t) { ++done; };
  const auto fail = [](std::size_t) { throw std::runtime_error("enough"); };
  EXPECT_THROW(on_all_cores(100000, count, fail), std::runtime_error);
  EXPECT_LT(done, 1000);
  done = 0;
  EXPECT_THROW(on_all_cores(100000, fail, count), std::runtime_error);
  EXPECT_EQ(done, 0);
}

TEST(OnAllCores, NothingIsDoneAtOnce) { on_all_cores(0, {}, {}); }

}  // namespace
}  // namespace wavecurve::verification
