#include "wavecurve/certified/integrals/homogeneous_operator.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve::certified {
namespace {

constexpr long bits = 110;
constexpr auto hilbert = HomogeneousOperator::Kind::hilbert;
constexpr auto fractional = HomogeneousOperator::Kind::fractional;
constexpr auto riesz = HomogeneousOperator::Kind::riesz;

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
        HomogeneousOperator{fractional, Rational(-3, 4)}, HomogeneousOperator{riesz, Rational(1)},
        HomogeneousOperator{riesz, Rational(-1, 3)}, HomogeneousOperator{hilbert, Rational(2)}}) {
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

// |w| has the kernel -1/(pi t^2), the fourth derivative of t^2 ln|t| / (2 pi); the correlation of the hat is
// the cubic spline, which takes fourth differences.
TEST(HomogeneousOperator, RieszDerivativeOfTheHatIsADifferenceOfItsKernel) {
  const WorkingPrecision precision(160);
  const auto r = coefficients("bspline2.2", {riesz, Rational(1)}, 20);
  const auto integral = [](int l) {
    return l == 0 ? Ball(0) : Ball(l) * Ball(l) * log(Ball(std::abs(l))) / (Ball(2) * Ball::pi());
  };
  for (int l = -20; l <= 20; ++l) {
    const Ball expected = integral(l - 2) - Ball(4) * integral(l - 1) + Ball(6) * integral(l) -
                          Ball(4) * integral(l + 1) + integral(l + 2);
    EXPECT_TRUE(r[l].overlaps(expected)) << l;
    EXPECT_LT(r[l].radius_double(), 1e-30) << l;
  }
}

// (i w)^s = |w|^s cos(pi s/2) - sin(pi s/2) (-i sgn(w) |w|^s).
TEST(HomogeneousOperator, TheFractionalDerivativeIsItsEvenAndItsOddPart) {
  const WorkingPrecision precision(160);
  for (const Rational& s : {Rational(1, 2), Rational(3, 2), Rational(-1, 2), Rational(7, 3)}) {
    const auto whole = coefficients("db4", {fractional, s}, 12);
    const auto even = coefficients("db4", {riesz, s}, 12);
    const auto odd = coefficients("db4", {hilbert, s}, 12);
    const Ball angle = Ball::pi() * Ball(s / Rational(2));
    for (int l = -12; l <= 12; ++l) {
      EXPECT_TRUE(whole[l].overlaps(cos(angle) * even[l] - sin(angle) * odd[l]))
          << s.to_string() << " " << l;
      EXPECT_LT(even[l].radius_double() + odd[l].radius_double(), 1e-28);
    }
  }
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

/// phi^(xi) = prod_{j>=1} m(xi / 2^j), m(xi) = sum_n a_n e^(-i n xi) / sqrt 2, a the taps.
std::complex<double> transform_of_phi(const Filter<double>& taps, double xi) {
  std::complex<double> product = 1;
  for (int j = 1; j <= 60; ++j) {
    std::complex<double> sum = 0;
    for (int n = taps.first_index; n <= taps.last_index(); ++n) {
      sum += taps[n] * std::polar(1.0, -n * std::ldexp(xi, -j));
    }
    product *= sum / std::numbers::sqrt2;
  }
  return product;
}

// |phi^(xi)|^2 falls like xi^(-2 e - 1) over octaves, e = 2.39 the Sobolev exponent of db6, so that the terms of an
// octave of frequencies are together below half of those of the octave before, for s < 2 e - 1: all that is left away,
// |j| > 300, is below the last octave. The products have 60 factors of a few roundings.
TEST(PeriodicOperator, HasTheEigenvaluesOfItsSymbol) {
  const int n = 12;
  const Filter<double> taps = find_filter_bank("db6").synthesis_low;
  const std::complex<double> i(0, 1);
  for (const HomogeneousOperator& op :
       {HomogeneousOperator{hilbert}, HomogeneousOperator{fractional, Rational(1, 2)},
        HomogeneousOperator{fractional, Rational(3, 2)},
        HomogeneousOperator{fractional, Rational(-3, 4)},
        HomogeneousOperator{fractional, Rational(-1)},
        HomogeneousOperator{fractional, Rational(-2)}, HomogeneousOperator{riesz, Rational(1)},
        HomogeneousOperator{riesz, Rational(-2, 3)}, HomogeneousOperator{riesz, Rational(5, 2)},
        HomogeneousOperator{hilbert, Rational(1, 2)}}) {
    const auto r = periodic_operator_coefficients(find_filter("db6"), op, n, bits);
    ASSERT_EQ(r.size(), n);
    const double s = Ball(op.order).to_double();
    for (int k = 0; k < n; ++k) {
      std::complex<double> expected = 0, last_octave = 0, found = 0;
      for (int j = -300; j <= 300; ++j) {
        const double xi = 2 * std::numbers::pi * (j + static_cast<double>(k) / n);
        if (xi == 0) continue;
        const double size = std::pow(std::abs(xi), s);
        const std::complex<double> symbol = op.kind == hilbert ? -i * std::copysign(size, xi)
                                            : op.kind == riesz ? size
                                                               : std::pow(i * xi, s);
        const std::complex<double> term = std::norm(transform_of_phi(taps, xi)) * symbol;
        expected += term;
        if (std::abs(j) > 150) last_octave += term;
      }
      for (int l = 0; l < n; ++l) {
        found += r[l].to_double() * std::polar(1.0, -2 * std::numbers::pi * k * l / n);
      }
      EXPECT_LT(std::abs(found - expected), std::abs(last_octave) + 1e-12)
          << op.order.to_string() << " " << k;
    }
  }
}

TEST(PeriodicOperator, IsAsAccurateAsAskedAndKillsConstants) {
  for (const int n : {1, 2, 5, 64}) {
    for (const HomogeneousOperator& op :
         {HomogeneousOperator{hilbert}, HomogeneousOperator{fractional, Rational(1, 3)},
          HomogeneousOperator{fractional, Rational(-5, 2)},
          HomogeneousOperator{riesz, Rational(1)}}) {
      const WorkingPrecision precision(200);
      Ball sum(0);
      for (const Ball& value :
           periodic_operator_coefficients(find_filter("db4"), op, n, bits).taps) {
        EXPECT_LT(value.radius_double(), 1e-28 * n * n * n);
        sum += value;
      }
      EXPECT_TRUE(sum.contains_zero()) << op.order.to_string() << " " << n;
    }
  }
}

TEST(PeriodicOperator, NearAWholeOrderIsThePeriodicDerivative) {
  const auto r = periodic_operator_coefficients(
      find_filter("db3"), {fractional, Rational(1) - Rational::power_of_two(-60)}, 3, bits);
  // r_l = -272/365, 53/365, -16/1095, -1/2920 of Beylkin, odd, folded into three: l = 1 takes 1, 4 and -2.
  const Rational one = Rational(-272, 365) - Rational(1, 2920) - Rational(53, 365);
  EXPECT_NEAR(std::abs(r[1].to_double()), std::abs(Ball(one).to_double()), 1e-15);
  EXPECT_NEAR(r[0].to_double(), 0, 1e-15);
  EXPECT_NEAR(r[1].to_double(), -r[2].to_double(), 1e-15);
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
  EXPECT_NE(refusal("db3", {hilbert, Rational(1)}).find("must not be an odd number"),
            std::string::npos);
  EXPECT_NE(refusal("db3", {riesz, Rational(2)}).find("must not be an even number"),
            std::string::npos);
  EXPECT_NE(refusal("db3", {riesz, Rational(-1)}).find("above -1"), std::string::npos);
  EXPECT_NE(refusal("db3", {hilbert}, 200'000).find("from 0 to 100000"), std::string::npos);
  for (const int period : {0, largest_operator_period + 1}) {
    EXPECT_THROW(periodic_operator_coefficients(find_filter("db3"), {hilbert}, period, bits),
                 std::invalid_argument);
  }
}

}  // namespace
}  // namespace wavecurve::certified
