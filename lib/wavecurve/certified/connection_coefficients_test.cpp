#include "wavecurve/certified/connection_coefficients.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include <boost/math/special_functions/daubechies_scaling.hpp>
#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve::certified {
namespace {

constexpr long bits = 150;

ConnectionCoefficients<Rational> exact(const std::string& name, int p = 1, int q = 1) {
  return *exact_connection_coefficients(find_filter(name), p, q);
}

ConnectionCoefficients<Ball> enclosed(const std::string& name, int p = 1, int q = 1) {
  return connection_coefficients(find_filter(name), p, q, bits);
}

TEST(ConnectionCoefficients, Db3HasBeylkinsFractions) {
  const auto mu = exact("db3").mu;
  EXPECT_EQ(mu[0], Rational(295, 56));
  EXPECT_EQ(mu[1], Rational(-356, 105));
  EXPECT_EQ(mu[2], Rational(92, 105));
  EXPECT_EQ(mu[3], Rational(-4, 35));
  EXPECT_EQ(mu[4], Rational(-3, 560));
  EXPECT_EQ(mu.last_index(), 4);
}

TEST(ConnectionCoefficients, SymletsShareThoseOfDaubechies) {
  for (const int order : {4, 7, 10, 20}) {
    const auto sym = exact("sym" + std::to_string(order));
    const auto db = exact("db" + std::to_string(order));
    EXPECT_EQ(sym.mu, db.mu);
    EXPECT_EQ(sym.nu, db.nu);
    EXPECT_TRUE(enclosed("sym" + std::to_string(order)).mu[1].contains(db.mu[1]));
  }
}

/// mu_l = -(d/dx)^2 of the B-spline of order 2D at l, by its exact formula about the middle D.
Rational spline_mu(int order, int l) {
  const int twice = 2 * order, degree = twice - 3;
  Rational sum(0);
  for (int k = 0; k < order + l; ++k) {
    Rational term =
        Rational::binomial(static_cast<unsigned long>(twice), static_cast<unsigned long>(k));
    for (int i = 0; i < degree; ++i) term *= Rational(order + l - k);
    sum += k % 2 == 0 ? -term : term;
  }
  return sum / Rational::factorial(static_cast<unsigned long>(degree));
}

TEST(ConnectionCoefficients, SplinesFollowFromTheSplineOfDoubleOrder) {
  for (int order = 2; order <= 7; ++order) {
    const auto mu = exact("bspline" + std::to_string(order) + "." + std::to_string(order)).mu;
    for (int l = -order; l <= order; ++l)
      EXPECT_EQ(mu[l], spline_mu(order, l)) << order << " " << l;
  }
}

TEST(ConnectionCoefficients, ReachTheAccuracyAskedForBeyondTheRangeOfDoubles) {
  constexpr long many_bits = 2000;
  const auto c = connection_coefficients(find_filter("coif2"), 1, 1, many_bits);
  EXPECT_TRUE(is_accurate(c, many_bits));
  EXPECT_FALSE(is_accurate(c, 2 * many_bits)) << "more was computed than was asked for";
}

TEST(ConnectionCoefficients, AreExactlyZeroAtZeroForAnOddOrder) {
  for (const char* name : {"coif2", "cdf9.7", "db3"}) {
    EXPECT_EQ(enclosed(name, 0, 1).mu[0], Ball(0)) << name;
    EXPECT_EQ(enclosed(name, 0, 1).nu[0], Ball(0)) << name;
  }
}

TEST(ConnectionCoefficients, EnclosuresHoldTheFractions) {
  for (const char* name : {"db3", "db9", "db38", "bspline4.4", "bspline3.7"}) {
    const auto fractions = exact(name);
    const auto balls = enclosed(name);
    for (int l = 0; l <= fractions.mu.last_index(); ++l) {
      EXPECT_TRUE(balls.mu[l].contains(fractions.mu[l])) << name << " mu " << l;
      EXPECT_TRUE(balls.nu[l].contains(fractions.nu[l])) << name << " nu " << l;
    }
  }
}

class EveryFamily : public testing::TestWithParam<const char*> {};

TEST_P(EveryFamily, MuHasItsMoments) {
  // sum_l mu_l = 0 and sum_l l^2 mu_l = -2; the solver imposes the second on half the sequence
  // only.
  const auto c = connection_coefficients(find_filter(GetParam()), 1, 1, bits);
  const WorkingPrecision precision(2 * bits);
  Ball sum(0), second_moment(0);
  for (int l = c.mu.first_index; l <= c.mu.last_index(); ++l) {
    sum += c.mu[l];
    second_moment += Ball(l) * Ball(l) * c.mu[l];
  }
  EXPECT_TRUE(sum.contains_zero());
  EXPECT_TRUE(second_moment.contains(Rational(-2)));
  EXPECT_LT(sum.radius_double() + second_moment.radius_double(), 1e-30);
}

TEST_P(EveryFamily, BothSatisfyTheGeneralTwoScaleRelation) {
  // The plain twin: the double sums of (3.10) and (3.12) as they are printed.
  const auto definition = find_filter(GetParam());
  const auto c = connection_coefficients(definition, 1, 1, bits);
  const auto bank = definition.bank(2 * bits);
  const WorkingPrecision precision(2 * bits);
  const auto double_sum = [&](const Filter<Ball>& filter, int l) {
    Ball sum(0);
    for (int m = filter.first_index; m <= filter.last_index(); ++m) {
      for (int n = filter.first_index; n <= filter.last_index(); ++n) {
        sum += filter[m] * filter[n] * c.mu[2 * l + m - n];
      }
    }
    return Ball(4) * sum;
  };
  for (int l = 0; l <= c.mu.last_index() + 2; ++l) {
    EXPECT_TRUE(c.mu[l].overlaps(double_sum(bank.synthesis_low, l))) << l;
  }
  for (int l = 0; l <= c.nu.last_index() + 2; ++l) {
    EXPECT_TRUE(c.nu[l].overlaps(double_sum(bank.synthesis_high, l))) << l;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, EveryFamily,
                         testing::Values("db3", "db4", "db10", "sym5", "coif1", "coif2", "coif5",
                                         "cdf9.7", "bspline2.2", "bspline4.4"),
                         [](const auto& family) {
                           std::string name = family.param;
                           for (char& c : name) c = c == '.' ? '_' : c;
                           return name;
                         });

TEST(ConnectionCoefficients, WaveletsOfOrthonormalFamiliesObey314) {
  for (const char* name : {"db4", "coif2", "sym6"}) {
    const auto c = enclosed(name);
    const WorkingPrecision precision(2 * bits);
    for (int l = 0; l <= c.nu.last_index(); ++l) {
      EXPECT_TRUE(c.nu[l].overlaps(Ball(8) * c.mu[2 * l] - c.mu[l])) << name << " " << l;
    }
  }
}

TEST(ConnectionCoefficients, MassOfAnOrthonormalFamilyIsTheIdentity) {
  for (const char* name : {"haar", "db2", "db5"}) {
    const auto c = exact(name, 0, 0);
    for (int l = c.mu.first_index; l <= c.mu.last_index(); ++l)
      EXPECT_EQ(c.mu[l], Rational(l == 0));
    for (int l = c.nu.first_index; l <= c.nu.last_index(); ++l)
      EXPECT_EQ(c.nu[l], Rational(l == 0));
  }
}

TEST(ConnectionCoefficients, OrdersShiftByPartialIntegration) {
  // int phi^(p)(x-l) phi^(q)(x) changes its sign with each derivative that changes sides.
  const auto direct = exact("db8", 1, 2), shifted = exact("db8", 0, 3), other = exact("db8", 3, 0);
  for (int l = direct.mu.first_index; l <= direct.mu.last_index(); ++l) {
    EXPECT_EQ(direct.mu[l], -shifted.mu[l]);
    EXPECT_EQ(direct.mu[l], other.mu[l]);
    EXPECT_EQ(direct.mu[l], -direct.mu[-l]);
  }
}

TEST(ConnectionCoefficients, AdvectionDifferentiatesALinearFunction) {
  // sum_l l int phi(x-l)' phi(x) dx = int (x)' phi = 1 up to constants: p = 1, q = 0.
  const auto c = exact("db4", 1, 0);
  Rational sum(0);
  for (int l = c.mu.first_index; l <= c.mu.last_index(); ++l) sum += Rational(l) * c.mu[l];
  EXPECT_EQ(sum, Rational(1));
}

/// Quadrature of phi'(x - l) phi'(x) on the dyadic grid of Boost.Math's own cascade.
template <int order>
void agrees_with_quadrature() {
  constexpr int levels = 14;
  const auto slope = boost::math::daubechies_scaling_dyadic_grid<double, order, 1>(levels);
  const auto mu = exact("db" + std::to_string(order)).mu;
  const std::size_t step = std::size_t{1} << levels;
  for (int l = 0; l <= 3; ++l) {
    const auto sum_at = [&](std::size_t stride) {
      double sum = 0;
      for (std::size_t i = static_cast<std::size_t>(l) * step; i < slope.size(); i += stride) {
        sum += slope[i] * slope[i - static_cast<std::size_t>(l) * step];
      }
      return sum * static_cast<double>(stride) / static_cast<double>(step);
    };
    // The error of the trapezoidal sum falls by a fixed factor with each halving of the step, so
    // that the last change bounds the error that is left, if the factor is at least 2.
    const double coarse = sum_at(2), fine = sum_at(1);
    const double rounding = 1e-11;  // 2^14 terms of size 10 in double
    EXPECT_NEAR(fine, mu[l].get() ? Ball(mu[l]).to_double() : 0.0,
                std::abs(fine - coarse) + rounding)
        << order << " " << l;
    EXPECT_LT(std::abs(fine - coarse), 1e-4);
  }
}

TEST(ConnectionCoefficients, AgreeWithQuadratureOnBoostsGrid) {
  agrees_with_quadrature<4>();
  agrees_with_quadrature<6>();
  agrees_with_quadrature<10>();
}

TEST(ConnectionCoefficients, RefuseARoughFamilyWithBothExponents) {
  for (const char* name : {"haar", "db2", "sym2", "bspline1.3"}) {
    EXPECT_THROW(enclosed(name), std::domain_error) << name;
  }
  try {
    enclosed("db2");
    FAIL();
  } catch (const std::domain_error& error) {
    EXPECT_STREQ(
        error.what(),
        "filter db2 is not smooth enough for derivatives 1,1: its Sobolev exponent is 1.000, "
        "but it must exceed 1.0");
  }
  EXPECT_THROW(enclosed("db4", 2, 2), std::domain_error);
  EXPECT_THROW(enclosed("db4", -1, 1), std::invalid_argument);
  EXPECT_THROW(enclosed("db38", 9, 0), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::certified
