#include "wavecurve/certified/integrals/homogeneous_operator.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"

namespace wavecurve::certified {
namespace {

constexpr long bits = 110;
constexpr auto hilbert = HomogeneousOperator::Kind::hilbert;
constexpr auto fractional = HomogeneousOperator::Kind::fractional;

Filter<Ball> coefficients(const std::string& filter, HomogeneousOperator op, int largest) {
  return operator_coefficients(find_filter(filter), op, largest, bits);
}

TEST(HomogeneousOperator, HilbertIsBeylkinsTable) {
  // Beylkin 1992, Table 3: six vanishing moments, to nine decimals; his sign is the opposite.
  const auto r = coefficients("db6", {hilbert}, 16);
  EXPECT_EQ(round_to_decimals(r[1], 9), "0.588303698");
  EXPECT_EQ(round_to_decimals(r[2], 9), "0.077576414");
  EXPECT_EQ(round_to_decimals(r[3], 9), "0.128743695");
  EXPECT_EQ(round_to_decimals(r[16], 9), "0.019894368");  // nearly 1/(16 pi)
}

TEST(HomogeneousOperator, ObeysTheTwoScaleRelationEverywhere) {
  const WorkingPrecision precision(200);
  for (const HomogeneousOperator& op :
       {HomogeneousOperator{hilbert}, HomogeneousOperator{fractional, Rational(1, 2)},
        HomogeneousOperator{fractional, Rational(-3, 4)}}) {
    const FilterDefinition definition = find_filter("db4");
    const auto r = operator_coefficients(definition, op, 60, bits);
    const Filter<Ball> h = definition.bank(200).synthesis_low;
    const Ball scale = exp(Ball(op.order) * log(Ball(2)));
    for (int l = -20; l <= 20; ++l) {
      Ball sum(0);
      for (int i = h.first_index; i <= h.last_index(); ++i) {
        for (int j = h.first_index; j <= h.last_index(); ++j) sum += h[i] * h[j] * r[2 * l + j - i];
      }
      EXPECT_TRUE((scale * sum).overlaps(r[l])) << op.order.to_string() << " " << l;
      EXPECT_LT(r[l].radius_double(), 1e-30);
    }
  }
}

TEST(HomogeneousOperator, IntegralsOfTheHatAreThoseOfItsPolynomials) {
  const auto r = coefficients("bspline2.2", {fractional, Rational(-1)}, 3);
  // The correlation of the hat is the cubic spline; r_l is its integral from minus infinity to l.
  EXPECT_TRUE(r[-2].contains(Rational(0)));
  EXPECT_TRUE(r[-1].contains(Rational(1, 24)));
  EXPECT_TRUE(r[0].contains(Rational(1, 2)));
  EXPECT_TRUE(r[1].contains(Rational(23, 24)));
  EXPECT_TRUE(r[2].contains(Rational(1)));
}

/// sum_{|l|<=L} r_l e^(-i l theta): what the operator multiplies e^(i theta x) by. What lies beyond
/// L is below 2 |r_L| / |1 - e^(i theta)|, for r_l falls steadily (Abel's inequality).
std::complex<double> symbol(const Filter<Ball>& r, double theta) {
  std::complex<double> sum = 0;
  for (int l = r.first_index; l <= r.last_index(); ++l) {
    sum += r[l].to_double() * std::polar(1.0, -l * theta);
  }
  return sum;
}

// The representation in the basis of phi is exact up to theta^(2N) for N vanishing moments (Beylkin
// 1992, section III): 0.196^12 = 4e-9 here, much below what the sums leave away.
TEST(HomogeneousOperator, TheHalfDerivativeTwiceIsTheDerivative) {
  const double theta = 2 * std::numbers::pi / 32;
  const int largest = 5000;
  const auto half = coefficients("db6", {fractional, Rational(1, 2)}, largest);
  const double beyond = 2 * std::abs(half[largest].to_double()) / theta * 1.01;
  const std::complex<double> once = symbol(half, theta);
  EXPECT_LT(std::abs(once * once - std::complex<double>(0, theta)),
            2 * std::abs(once) * beyond + 1e-8);
  EXPECT_LT(beyond, 1e-5);
}

TEST(HomogeneousOperator, HilbertSquaredIsMinusOne) {
  const double theta = 2 * std::numbers::pi / 32;
  const int largest = 5000;
  const auto r = coefficients("db6", {hilbert}, largest);
  const double beyond = 4 * r[largest].to_double() / theta * 1.01;
  const std::complex<double> once = symbol(r, theta);
  EXPECT_LT(std::abs(once * once + 1.0), 2 * beyond + 1e-8);
  EXPECT_LT(beyond, 2e-3);
}

TEST(HomogeneousOperator, OrdersNearAWholeOneGoOverIntoTheDerivative) {
  const auto nearly =
      coefficients("db3", {fractional, Rational(1) - Rational::power_of_two(-60)}, 4);
  // r_l of d/dx: 272/365 at 1 in magnitude (Beylkin's D6), with the error of the order: 2^-60 times
  // a few.
  const Rational known[] = {Rational(0), Rational(272, 365), Rational(53, 365), Rational(16, 1095),
                            Rational(1, 2920)};
  for (int l = 0; l <= 4; ++l) {
    EXPECT_NEAR(abs(nearly[l]).to_double(), Ball(known[l]).to_double(), 1e-16) << l;
  }
}

TEST(HomogeneousOperator, RefusesWhatHasNoUniqueSolution) {
  const auto refusal = [](const std::string& filter, HomogeneousOperator op,
                          int largest = 5) -> std::string {
    try {
      coefficients(filter, op, largest);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal("db3", {fractional, Rational(2)}).find("the two-scale system is singular"),
            std::string::npos);
  EXPECT_NE(refusal("db2", {fractional, Rational(5, 2)})
                .find("its Sobolev exponent is 1.000, but it must exceed 1.25"),
            std::string::npos);
  EXPECT_NE(refusal("db3", {fractional, Rational(17, 2)}).find("from -8 to 8"), std::string::npos);
  EXPECT_NE(refusal("db3", {hilbert, Rational(1)}).find("must be 0"), std::string::npos);
  EXPECT_NE(refusal("db3", {hilbert}, 200'000).find("from 0 to 100000"), std::string::npos);
}

}  // namespace
}  // namespace wavecurve::certified
