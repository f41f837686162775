#include "verdict.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::tracking {
namespace {

TEST(Verdict, OfATimeNeedsIntervalAndThreshold) {
  EXPECT_EQ(judge_time({1.10, 1.02, 1.15}, 0.05), Verdict::slower);
  EXPECT_EQ(judge_time({1.10, 0.99, 1.15}, 0.05), Verdict::inconclusive);  // holds 1
  EXPECT_EQ(judge_time({1.04, 1.02, 1.06}, 0.05), Verdict::inconclusive);  // not large enough
  EXPECT_EQ(judge_time({1.02, 1.01, 1.03}, 0.05), Verdict::same);
  EXPECT_EQ(judge_time({0.90, 0.88, 0.92}, 0.05), Verdict::faster);
  EXPECT_EQ(judge_time({0.90, 0.80, 1.01}, 0.05), Verdict::inconclusive);
}

TEST(Verdict, OfACountIsTheThreshold) {
  EXPECT_EQ(judge_count(100000, 101000, 0.01), Verdict::slower);
  EXPECT_EQ(judge_count(100000, 100990, 0.01), Verdict::same);
  EXPECT_EQ(judge_count(101000, 100000, 0.01), Verdict::faster);
  EXPECT_EQ(judge_count(100000, 99100, 0.01), Verdict::same);
  EXPECT_EQ(judge_count(0, 0, 0.01), Verdict::same);
  EXPECT_EQ(judge_count(0, 1, 0.01), Verdict::slower);
}

TEST(Verdict, ALossOfAccuracyIsARegression) {
  const Thresholds thresholds;
  EXPECT_EQ(judge_accuracy("error", 1e-9, 1.2e-9, thresholds), Verdict::slower);
  EXPECT_EQ(judge_accuracy("error", 1e-9, 1.05e-9, thresholds), Verdict::same);
  EXPECT_EQ(judge_accuracy("error", 1e-9, 0.5e-9, thresholds), Verdict::faster);
  EXPECT_EQ(judge_accuracy("error", 0, 1e-18, thresholds), Verdict::slower);
  EXPECT_EQ(judge_accuracy("error", 1e-9, std::nan(""), thresholds), Verdict::slower);
  EXPECT_EQ(judge_accuracy("iterations", 100, 101, thresholds), Verdict::slower);
  EXPECT_EQ(judge_accuracy("iterations", 1000, 1001, thresholds), Verdict::same);
  EXPECT_EQ(judge_accuracy("digits", 50, 49.9, thresholds), Verdict::slower);
  EXPECT_EQ(judge_accuracy("digits", 50, 49.99, thresholds), Verdict::same);
  EXPECT_EQ(judge_accuracy("digits", 50, std::nan(""), thresholds), Verdict::slower);
  EXPECT_EQ(judge_accuracy("digits", 50, 51, thresholds), Verdict::faster);
  EXPECT_THROW(judge_accuracy("beauty", 1, 1, thresholds), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::tracking
