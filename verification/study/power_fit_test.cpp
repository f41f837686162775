#include "verification/study/power_fit.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

TEST(PowerFit, FindsAPowerExactly) {
  const PowerFit fit = fit_power({1, 2, 4, 8}, {3, 12, 48, 192});
  EXPECT_NEAR(fit.exponent, 2, 1e-14);
  EXPECT_NEAR(fit.high - fit.low, 0, 1e-13);
  EXPECT_EQ(fit.points, 4u);
}

TEST(PowerFit, IntervalIsStudents) {
  // By hand: deviations (e, -2e, e) of the line through x = -1, 0, 1 leave the slope; with one
  // degree of freedom the 97.5 % quantile is 12.706, the slope's deviation sqrt(6 e^2 / 1 / 2).
  const double e = 0.01;
  const PowerFit fit = fit_power({std::exp(-1), 1, std::exp(1)},
                                 {std::exp(-1 + e), std::exp(-2 * e), std::exp(1 + e)});
  EXPECT_NEAR(fit.exponent, 1, 1e-14);
  EXPECT_NEAR(fit.high - 1, 12.706 * std::sqrt(3) * e, 1e-5);
  EXPECT_NEAR(1 - fit.low, 12.706 * std::sqrt(3) * e, 1e-5);
}

TEST(PowerFit, IntervalHoldsTheTruthNineteenTimesInTwenty) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.1);
  constexpr int trials = 4000;
  int inside = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> x, y;
    for (int i = 0; i < 6; ++i) {
      x.push_back(std::exp2(i));
      y.push_back(std::pow(x.back(), -1.5) * std::exp(noise(random)));
    }
    const PowerFit fit = fit_power(x, y);
    if (fit.low <= -1.5 && -1.5 <= fit.high) ++inside;
  }
  // 0.95 but for five standard deviations of the binomial distribution.
  EXPECT_NEAR(inside / double(trials), 0.95, 5 * std::sqrt(0.95 * 0.05 / trials));
}

TEST(PowerFit, RefusesWhatIsNoPower) {
  EXPECT_THROW(fit_power({1, 2}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(fit_power({1, 2, 3}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(fit_power({1, 2, 3}, {1, 0, 2}), std::invalid_argument);
  EXPECT_THROW(fit_power({1, 2, -3}, {1, 1, 2}), std::invalid_argument);
  EXPECT_THROW(fit_power({2, 2, 2}, {1, 1, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::verification
