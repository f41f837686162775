#include "wavecurve/certified/point_values.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"

namespace wavecurve::certified {
namespace {

constexpr long bits = 128;

TEST(DyadicValues, ObeyTheTwoScaleRelationAndThePartitionOfUnity) {
  const FilterDefinition definition = find_filter("db4");
  const auto coarse = dyadic_values(definition, {}, 2, bits);
  const auto fine = dyadic_values(definition, {}, 3, bits);
  for (int k = -4; k <= 32; ++k) EXPECT_TRUE(coarse[k].overlaps(fine[2 * k])) << k;
  for (int offset = 0; offset < 8; ++offset) {
    Ball sum(0);
    for (int l = -8; l <= 8; ++l) sum += fine[offset + 8 * l];
    EXPECT_TRUE(sum.contains(Rational(1))) << offset;
    EXPECT_LT(sum.radius_double(), 1e-30);
  }
}

TEST(DyadicValues, AreKnownInClosedFormForD4AtOne) {
  const WorkingPrecision precision(bits);
  const auto values = dyadic_values(find_filter("db2"), {}, 0, bits);
  EXPECT_TRUE(values[1].overlaps((Ball(1) + sqrt(Ball(3))) / Ball(2)));
  EXPECT_TRUE(values[2].overlaps((Ball(1) - sqrt(Ball(3))) / Ball(2)));
}

TEST(DyadicValues, AreThoseOfThePolynomialsOfASplineAndItsDerivative) {
  // The quadratic B-spline on [0, 3] from the publication's side, moved to its first index.
  const FilterDefinition definition = find_filter("bspline3.3");
  const int first = definition.bank(bits).synthesis_low.first_index;
  const auto values = dyadic_values(definition, {}, 1, bits);
  const auto slopes = dyadic_values(definition, {.derivative = 1}, 1, bits);
  EXPECT_TRUE(values[2 * first + 1].contains(Rational(1, 8)));
  EXPECT_TRUE(values[2 * first + 2].contains(Rational(1, 2)));
  EXPECT_TRUE(values[2 * first + 3].contains(Rational(3, 4)));
  EXPECT_TRUE(slopes[2 * first + 1].contains(Rational(1, 2)));
  EXPECT_TRUE(slopes[2 * first + 3].contains(Rational(0)));
}

TEST(DyadicValues, AreTheSameAtEveryLevelForAWavelet) {
  const FilterDefinition definition = find_filter("coif2");
  const BasisFunction psi{.wavelet = true};
  const auto integers = dyadic_values(definition, psi, 0, bits);
  const auto halves = dyadic_values(definition, psi, 1, bits);
  const auto quarters = dyadic_values(definition, psi, 2, bits);
  for (int k = -12; k <= 12; ++k) {
    EXPECT_TRUE(integers[k].overlaps(halves[2 * k]));
    EXPECT_TRUE(integers[k].overlaps(quarters[4 * k]));
  }
}

TEST(DyadicValues, RefuseWhatIsNotContinuous) {
  EXPECT_THROW(dyadic_values(find_filter("db1"), {}, 0, bits), std::domain_error);
  EXPECT_THROW(dyadic_values(find_filter("db2"), {.derivative = 1}, 0, bits), std::domain_error);
  EXPECT_THROW(dyadic_values(find_filter("db4"), {}, 11, bits), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::certified
