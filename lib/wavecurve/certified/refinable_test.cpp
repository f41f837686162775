#include "wavecurve/certified/refinable.hpp"

#include <array>
#include <stdexcept>

#include <boost/math/special_functions/daubechies_scaling.hpp>
#include <gtest/gtest.h>

#include "wavecurve/certified/detail/polynomial.hpp"
#include "wavecurve/certified/find_filter.hpp"

namespace wavecurve::certified {
namespace {

constexpr long bits = 200;

Filter<Ball> mask_of(const std::string& name) {
  Filter<Ball> mask = find_filter(name).bank(bits).synthesis_low;
  const Ball root_two = sqrt(Ball(2));
  for (Ball& tap : mask.taps) tap *= root_two;
  return mask;
}

/// The B-spline of order D on [0, D]: 1/(D-1)! sum_k (-1)^k binomial(D, k) (x - k)_+^(D-1), its
/// d-th derivative at an integer.
Rational spline_derivative(int order, int d, long x) {
  Rational sum(0);
  const int degree = order - 1 - d;
  for (long k = 0; k < x && k <= order; ++k) {
    Rational term =
        Rational::binomial(static_cast<unsigned long>(order), static_cast<unsigned long>(k));
    for (int i = 0; i < degree; ++i) term *= Rational(x - k);
    sum += k % 2 == 0 ? term : -term;
  }
  return sum / Rational::factorial(static_cast<unsigned long>(degree));
}

TEST(DerivativeAtIntegers, SplinesHaveTheirExactValues) {
  for (int order = 3; order <= 8; ++order) {
    Filter<Rational> mask{0, averaging_polynomial<Rational>(order)};
    for (Rational& a : mask.taps) a *= Rational(2);
    for (int d = 0; d + 2 < order; ++d) {
      const auto values = derivative_at_integers(mask, d);
      for (int x = 1; x < order; ++x) {
        EXPECT_EQ(values[x], spline_derivative(order, d, x)) << order << " " << d << " " << x;
      }
    }
  }
}

TEST(DerivativeAtIntegers, TheSymmetricSystemGivesTheSame) {
  for (const int order : {4, 6, 8}) {
    Filter<Rational> mask{-order / 2, averaging_polynomial<Rational>(order)};
    for (Rational& a : mask.taps) a *= Rational(2);
    Filter<Rational> alpha{0, {}};  // twice the mask
    for (int k = 0; k <= order / 2; ++k) alpha.taps.push_back(mask[k] + mask[k]);
    for (int d = 0; d + 2 < order; ++d) {
      const auto whole = derivative_at_integers(mask, d);
      const auto symmetric = autocorrelation_derivative_at_integers(alpha, d);
      for (int l = -order / 2; l <= order / 2; ++l)
        EXPECT_EQ(whole[l], symmetric[l]) << d << " " << l;
    }
  }
}

TEST(DerivativeAtIntegers, Db2HasItsClosedForm) {
  const WorkingPrecision precision(bits);
  const auto phi = derivative_at_integers(mask_of("db2"), 0);
  EXPECT_TRUE(phi[1].overlaps((Ball(1) + sqrt(Ball(3))) / Ball(2)));
  EXPECT_TRUE(phi[2].overlaps((Ball(1) - sqrt(Ball(3))) / Ball(2)));
}

TEST(DerivativeAtIntegers, ReproducesPolynomials) {
  // sum_l l^j phi^(d)(l) = 0 for j < d, and (-1)^d d! for j = d, of which only the last was
  // imposed.
  const WorkingPrecision precision(bits);
  for (const char* name : {"db6", "sym8", "coif3", "cdf9.7", "bspline5.3"}) {
    for (const int d : {0, 1}) {
      const auto values = derivative_at_integers(mask_of(name), d);
      for (int j = 0; j <= d; ++j) {
        Ball sum(0);
        for (int l = values.first_index; l <= values.last_index(); ++l) {
          sum += (j == 0 ? Ball(1) : Ball(l)) * values[l];
        }
        EXPECT_TRUE(sum.contains(Rational(j < d    ? 0
                                          : d == 0 ? 1
                                                   : -1)))
            << name << " " << d << " " << j;
        EXPECT_LT(sum.radius_double(), 1e-40);
      }
    }
  }
}

TEST(DerivativeAtIntegers, AgreesWithBoostMath) {
  const WorkingPrecision precision(bits);
  const boost::math::daubechies_scaling<double, 6> boost_phi;
  const auto phi = derivative_at_integers(mask_of("db6"), 0);
  const auto slope = derivative_at_integers(mask_of("db6"), 1);
  for (int l = 1; l < 11; ++l) {
    // Boost interpolates a grid of values near 1 in size, correct to a few ulps.
    EXPECT_NEAR(boost_phi(l), phi[l].to_double(), 16 * std::numeric_limits<double>::epsilon());
    EXPECT_NEAR(boost_phi.prime(l), slope[l].to_double(),
                64 * std::numeric_limits<double>::epsilon());
  }
}

TEST(DerivativeAtIntegers, RefusesWhatHasNoInnerInteger) {
  EXPECT_THROW(derivative_at_integers(Filter<Rational>{0, {1, 1}}, 0), std::domain_error);
}

TEST(DerivativeAtIntegers, RefusesASingularSystem) {
  // Without polynomial reproduction of degree 1 the derivative's system has no null vector.
  EXPECT_THROW(derivative_at_integers(Filter<Rational>{0, {0, 1, 0, 1, 0}}, 1), std::domain_error);
}

}  // namespace
}  // namespace wavecurve::certified
