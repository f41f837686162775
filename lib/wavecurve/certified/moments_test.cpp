#include "wavecurve/certified/moments.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/point_values.hpp"

namespace wavecurve::certified {
namespace {

constexpr long bits = 160;

TEST(Moments, AreThoseOfASumOfUniformVariablesForASpline) {
  // bspline4.4: the sum of four uniform variables on an interval of length 1, mean 0, variance 4/12.
  const auto m = moments(find_filter("bspline4.4"), {}, 4, bits);
  const int expected[][2] = {{1, 1}, {0, 1}, {1, 3}, {0, 1}, {3, 10}};
  for (std::size_t p = 0; p < 5; ++p) {
    EXPECT_TRUE(m[p].contains(Rational(expected[p][0], expected[p][1]))) << p;
  }
}

TEST(Moments, VanishForCoiflets) {
  const auto m = moments(find_filter("coif2"), {}, 5, bits);
  for (std::size_t p = 1; p <= 3; ++p) EXPECT_TRUE(m[p].contains_zero()) << p;
  EXPECT_FALSE(m[5].contains_zero());
}

TEST(Moments, VanishForAWaveletUpToTheOtherSidesZeros) {
  const BasisFunction psi{.wavelet = true};
  for (const std::string name : {"db3", "cdf9.7", "bspline3.1"}) {
    const FilterDefinition definition = find_filter(name);
    const int vanishing = definition.bank(bits).dual_vanishing_moments;
    const auto m = moments(definition, psi, vanishing, bits);
    EXPECT_FALSE(m.back().contains_zero()) << name;
    for (int p = 0; p < vanishing; ++p) EXPECT_TRUE(m[std::size_t(p)].is_exact());
  }
}

TEST(Moments, AreTheSumsOverTheIntegersThatPolynomialReproductionMakesThem) {
  // For p below the number of reproduced degrees the trapezoidal rule is exact.
  const auto m = moments(find_filter("db4"), {}, 3, bits);
  const auto values = dyadic_values(find_filter("db4"), {}, 0, bits);
  for (unsigned long p = 0; p <= 3; ++p) {
    Ball sum(0);
    for (int k = 0; k <= 7; ++k) sum += pow(Ball(k), p) * values[k];
    EXPECT_TRUE(sum.overlaps(m[p])) << p;
    EXPECT_LT((sum - m[p]).radius_double(), 1e-25);
  }
}

TEST(Moments, RefuseADerivative) {
  EXPECT_THROW(moments(find_filter("db4"), {.derivative = 1}, 3, bits), std::invalid_argument);
  EXPECT_THROW(moments(find_filter("db4"), {}, 101, bits), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::certified
