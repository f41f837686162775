#include "benchmarks/tracking/bootstrap.hpp"

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "benchmarks/tracking/change.hpp"

namespace wavecurve::tracking {
namespace {

using Noise = std::function<double(std::mt19937_64&)>;

// Logarithms of what disturbs a time: as if by many small causes; as other programs do, which only
// add; and rarely, but then by much.
double normal(std::mt19937_64& random) { return std::normal_distribution(0.0, 0.03)(random); }
double exponential(std::mt19937_64& random) {
  return std::exponential_distribution(1 / 0.03)(random);
}
double bursts(std::mt19937_64& random) {
  const double small = std::normal_distribution(0.0, 0.01)(random);
  const bool is_disturbed = std::bernoulli_distribution(0.15)(random);
  return is_disturbed ? small + std::exponential_distribution(1 / 0.3)(random) : small;
}

/// Blocks of two programs whose times differ by the ratio, on a machine that grows slower by a
/// third within each block.
std::vector<Block> simulate(double ratio, int blocks, const Noise& noise, std::mt19937_64& random) {
  std::vector<Block> result;
  for (int i = 0; i < blocks; ++i) {
    const double speed = std::exp(normal(random) * 5);
    const auto time = [&](double of_program, double place) {
      return speed * of_program * std::exp(0.1 * place + noise(random));
    };
    result.push_back({time(1, 0), time(ratio, 1), time(ratio, 2), time(1, 3)});
  }
  return result;
}

double share_covered(double ratio, int blocks, const Noise& noise) {
  constexpr int trials = 1000;
  std::mt19937_64 random(7);
  int covered = 0;
  for (int i = 0; i < trials; ++i) {
    const auto interval = bootstrap_ratio(simulate(ratio, blocks, noise, random), 0.99, 1996, 500);
    covered += interval.lower <= ratio && ratio <= interval.upper ? 1 : 0;
  }
  return static_cast<double>(covered) / trials;
}

TEST(Bootstrap, IntervalCoversTheTrueRatio) {
  // Nominal is 0.99; at 12 blocks the percentile interval of a median is a little short. 0.97 less
  // three standard deviations of 1000 trials, sqrt(0.97 0.03 / 1000) = 0.0054, is 0.954.
  for (const Noise& noise : {Noise(normal), Noise(exponential), Noise(bursts)}) {
    for (const double ratio : {1.0, 1.05, 0.7}) {
      EXPECT_GT(share_covered(ratio, 12, noise), 0.954) << ratio;
    }
  }
}

TEST(Bootstrap, IsNotNeedlesslyWide) {
  // The order statistics 2 and 11 of 12 cover in 99.4 %; of normal noise of 0.03 a block's
  // logarithm has standard deviation 0.03, and these two lie at +-1.12 of them on average.
  std::mt19937_64 random(1);
  double width = 0;
  for (int i = 0; i < 200; ++i) {
    const auto interval = bootstrap_ratio(simulate(1, 12, normal, random), 0.99, 1996, 500);
    width += std::log(interval.upper / interval.lower) / 200;
  }
  EXPECT_LT(width, 2 * 1.12 * 0.03);
}

TEST(Bootstrap, LinearDriftCancels) {
  const std::vector<Block> blocks(12, {1.0, std::exp(0.1), std::exp(0.2), std::exp(0.3)});
  const auto interval = bootstrap_ratio(blocks);
  EXPECT_NEAR(interval.lower, 1, 1e-15);
  EXPECT_NEAR(interval.upper, 1, 1e-15);
}

TEST(Bootstrap, SameSeedSameInterval) {
  std::mt19937_64 random(3);
  const auto blocks = simulate(1.1, 12, normal, random);
  EXPECT_EQ(bootstrap_ratio(blocks).lower, bootstrap_ratio(blocks).lower);
  EXPECT_NE(bootstrap_ratio(blocks, 0.99, 1).lower, bootstrap_ratio(blocks, 0.99, 2).lower);
}

TEST(Bootstrap, ComparesTwoGroups) {
  std::mt19937_64 random(5);
  std::vector<double> a, b;
  for (int i = 0; i < 30; ++i) {
    a.push_back(std::exp(normal(random)));
    b.push_back(2 * std::exp(normal(random)));
  }
  const auto interval = bootstrap_ratio(a, b);
  EXPECT_LT(interval.lower, 2);
  EXPECT_GT(interval.upper, 2);
  EXPECT_LT(interval.upper - interval.lower, 0.4);
  EXPECT_THROW(bootstrap_ratio(std::vector<Block>()), std::invalid_argument);
}

TEST(Bootstrap, Median) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_THROW(median({}), std::invalid_argument);
}

/// How often a measurement and the one that confirms it agree on slower.
double share_of_alarms(double ratio, const Noise& noise) {
  constexpr int trials = 1000;
  std::mt19937_64 random(11);
  const auto is_slower = [&] {
    const auto interval = bootstrap_ratio(simulate(ratio, 12, noise, random), 0.99, 1996, 500);
    return judge_time(interval, Thresholds().time) == Change::slower;
  };
  int alarms = 0;
  for (int i = 0; i < trials; ++i) alarms += is_slower() && is_slower() ? 1 : 0;
  return static_cast<double>(alarms) / trials;
}

TEST(Alarm, IsSilentWhereNothingChanged) {
  // One in 1000 would be one in 50 rounds of 20 kernels.
  for (const Noise& noise : {Noise(normal), Noise(exponential), Noise(bursts)}) {
    EXPECT_LE(share_of_alarms(1, noise), 0.001);
    // A change that does not matter is no alarm however sure it is: the estimate of 1.02 has a
    // standard error of 0.01, the threshold of 1.05 is three of them away, and twice so.
    EXPECT_LE(share_of_alarms(1.02, noise), 0.002);
  }
}

TEST(Alarm, FindsWhatMatters) {
  // 1.20 is 0.18 from 1 in logarithms, 0.13 from the threshold; ten standard errors of normal
  // noise. Nearly half of the blocks with bursts have one; the interval reaches 1 in one of twelve
  // measurements, so two of them agree in 0.92^2 = 0.84; three deviations of 1000 trials are 0.035.
  EXPECT_GE(share_of_alarms(1.20, normal), 0.99);
  EXPECT_GE(share_of_alarms(1.20, exponential), 0.99);
  EXPECT_GE(share_of_alarms(1.20, bursts), 0.80);
}

}  // namespace
}  // namespace wavecurve::tracking
