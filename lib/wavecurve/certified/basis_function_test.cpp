#include "wavecurve/certified/basis_function.hpp"

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"

namespace wavecurve::certified {
namespace {

TEST(BasisFunction, HasItsNameInThePublicationsLetters) {
  EXPECT_EQ(name_of({}), "phi");
  EXPECT_EQ(name_of({.wavelet = true, .derivative = 2}), "psi''");
  EXPECT_EQ(name_of({.dual = true, .derivative = 4}), "phi~^(4)");
}

TEST(BasisFunction, TwoScaleCoefficientsAddUpToTwoOrToZero) {
  const WorkingPrecision precision(128);
  for (const std::string name : {"db3", "cdf9.7", "bspline3.1"}) {
    const FilterBank<Ball> bank = find_filter(name).bank(128);
    for (const bool dual : {false, true}) {
      Ball low(0), high(0);
      for (const Ball& a : two_scale_coefficients(bank, {false, dual, 0}).taps) low += a;
      for (const Ball& a : two_scale_coefficients(bank, {true, dual, 0}).taps) high += a;
      EXPECT_TRUE(low.contains(Rational(2))) << name;
      EXPECT_TRUE(high.contains_zero()) << name;
    }
  }
}

TEST(BasisFunction, SupportsAreThoseOfTheTwoScaleRelation) {
  const FilterBank<Ball> bank = find_filter("db3").bank(64);
  EXPECT_EQ(support(bank, {}).first, 0);
  EXPECT_EQ(support(bank, {}).last, 5);
  EXPECT_EQ(support(bank, {.wavelet = true}).first, -2);
  EXPECT_EQ(support(bank, {.wavelet = true}).last, 3);
}

TEST(BasisFunction, ADerivativeLowersTheSobolevExponentByItsOrder) {
  const Ball s = sobolev_exponent(find_filter("bspline4.4"), {.derivative = 2});
  EXPECT_TRUE(s.contains(Rational(3, 2)));
}

}  // namespace
}  // namespace wavecurve::certified
