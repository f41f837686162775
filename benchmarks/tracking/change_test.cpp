#include "benchmarks/tracking/change.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::tracking {
namespace {

TEST(Change, InATimeNeedsIntervalAndThreshold) {
  EXPECT_EQ(judge_time({1.10, 1.02, 1.15}, 0.05), Change::slower);
  EXPECT_EQ(judge_time({1.10, 0.99, 1.15}, 0.05), Change::inconclusive);  // holds 1
  EXPECT_EQ(judge_time({1.04, 1.02, 1.06}, 0.05), Change::inconclusive);  // not large enough
  EXPECT_EQ(judge_time({1.02, 1.01, 1.03}, 0.05), Change::same);
  EXPECT_EQ(judge_time({0.90, 0.88, 0.92}, 0.05), Change::faster);
  EXPECT_EQ(judge_time({0.90, 0.80, 1.01}, 0.05), Change::inconclusive);
}

TEST(Change, InACountNeedsTheThresholdAlone) {
  EXPECT_EQ(judge_count(100000, 101000, 0.01), Change::slower);
  EXPECT_EQ(judge_count(100000, 100990, 0.01), Change::same);
  EXPECT_EQ(judge_count(101000, 100000, 0.01), Change::faster);
  EXPECT_EQ(judge_count(100000, 99100, 0.01), Change::same);
  EXPECT_EQ(judge_count(0, 0, 0.01), Change::same);
  EXPECT_EQ(judge_count(0, 1, 0.01), Change::slower);
}

TEST(Change, ALossOfAccuracyIsARegression) {
  const Thresholds thresholds;
  EXPECT_EQ(judge_accuracy("error", 1e-9, 1.2e-9, thresholds), Change::slower);
  EXPECT_EQ(judge_accuracy("error", 1e-9, 1.05e-9, thresholds), Change::same);
  EXPECT_EQ(judge_accuracy("error", 1e-9, 0.5e-9, thresholds), Change::faster);
  EXPECT_EQ(judge_accuracy("error", 0, 1e-18, thresholds), Change::slower);
  EXPECT_EQ(judge_accuracy("error", 1e-9, std::nan(""), thresholds), Change::slower);
  EXPECT_EQ(judge_accuracy("iterations", 100, 101, thresholds), Change::slower);
  EXPECT_EQ(judge_accuracy("iterations", 1000, 1001, thresholds), Change::same);
  EXPECT_EQ(judge_accuracy("digits", 50, 49.9, thresholds), Change::slower);
  EXPECT_EQ(judge_accuracy("digits", 50, 49.99, thresholds), Change::same);
  EXPECT_EQ(judge_accuracy("digits", 50, std::nan(""), thresholds), Change::slower);
  EXPECT_EQ(judge_accuracy("digits", 50, 51, thresholds), Change::faster);
  EXPECT_THROW(judge_accuracy("beauty", 1, 1, thresholds), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::tracking
