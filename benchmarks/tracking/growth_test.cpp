#include "benchmarks/tracking/growth.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::tracking {
namespace {

const std::vector<double> sizes{256, 1024, 4096, 16384};

template <class Cost>
GrowthFit fit(Cost cost, const std::string& stated) {
  std::vector<double> costs;
  for (const double size : sizes) costs.push_back(cost(size));
  return fit_growth(sizes, costs, stated);
}

TEST(Growth, IsOneAsStated) {
  const GrowthFit linear = fit([](double n) { return 7 * n; }, "N");
  EXPECT_NEAR(linear.exponent, 1, 1e-12);
  EXPECT_NEAR(linear.upper - linear.lower, 0, 1e-6);
  EXPECT_NEAR(fit([](double n) { return n * std::log(n); }, "N log N").exponent, 1, 1e-12);
}

TEST(Growth, FindsWhatGrowsFaster) {
  EXPECT_TRUE(fit([](double n) { return n * n; }, "N log N").exceeds_stated());
  EXPECT_TRUE(fit([](double n) { return n * n + 1000 * n; }, "N").exceeds_stated());
  EXPECT_TRUE(fit([](double n) { return n * std::log(n); }, "N").exceeds_stated());
  EXPECT_TRUE(fit([](double n) { return std::pow(n, 1.4); }, "N log N").exceeds_stated());
}

TEST(Growth, LetsLowerOrderTermsPass) {
  EXPECT_FALSE(fit([](double n) { return n + 5000; }, "N").exceeds_stated());
  EXPECT_FALSE(fit([](double n) { return n * std::log(n) - 2 * n; }, "N log N").exceeds_stated());
  EXPECT_FALSE(fit([](double n) { return n; }, "N log N").exceeds_stated());
}

TEST(Growth, IntervalCoversTheExponent) {
  std::mt19937_64 random(4);
  std::normal_distribution noise(0.0, 0.05);
  constexpr int trials = 2000;
  int covered = 0;
  for (int i = 0; i < trials; ++i) {
    const auto found =
        fit([&](double n) { return std::pow(n, 1.2) * std::exp(noise(random)); }, "N");
    covered += found.lower <= 1.2 && 1.2 <= found.upper ? 1 : 0;
  }
  // Exact for normal noise: 0.95, and three standard deviations of 2000 trials are 0.015.
  EXPECT_NEAR(static_cast<double>(covered) / trials, 0.95, 0.015);
}

TEST(Growth, RefusesWhatItCannotFit) {
  EXPECT_THROW(fit_growth({2, 4}, {1, 2}, "N"), std::invalid_argument);
  EXPECT_THROW(fit_growth({2, 4, 8}, {1, 0, 2}, "N"), std::invalid_argument);
  EXPECT_THROW(fit_growth({2, 4, 8}, {1, 2, 4}, "N^2"), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::tracking
