#include "wavecurve/certified/integrals/quadrature.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/moments.hpp"
#include "wavecurve/certified/point_values.hpp"

namespace wavecurve::certified {
namespace {

constexpr long bits = 128;

void expect_exact_up_to_degree(const QuadratureRule& rule, const FilterDefinition& definition) {
  const auto known = moments(definition, {}, rule.degree + 1, bits);
  for (int p = 0; p <= rule.degree + 1; ++p) {
    Ball sum(0);
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      sum += rule.weights[k] * pow(rule.nodes[k], static_cast<unsigned long>(p));
    }
    const Ball error = known[static_cast<std::size_t>(p)] - sum;
    EXPECT_TRUE(p <= rule.degree ? error.contains_zero() : error.overlaps(rule.next_error)) << p;
    EXPECT_LT(error.radius_double(), 1e-25);
  }
}

TEST(Quadrature, RulesAreExactUpToTheirDegree) {
  const WorkingPrecision precision(bits);
  for (const std::string name : {"db4", "coif2", "bspline3.3", "cdf9.7"}) {
    const FilterDefinition definition = find_filter(name);
    expect_exact_up_to_degree(equidistant_rule(definition, Rational(0), Rational(1), 5, bits),
                              definition);
    expect_exact_up_to_degree(
        equidistant_rule(definition, Rational(-1, 2), Rational(1, 4), 3, bits), definition);
    expect_exact_up_to_degree(one_point_rule(definition, bits), definition);
  }
}

TEST(Quadrature, OneNodeHasDegreeTwoForOrthonormalBanks) {
  // M_2 = M_1^2, but not for splines, where the next error is the variance, order / 12.
  EXPECT_EQ(one_point_rule(find_filter("db4"), bits).degree, 2);
  EXPECT_FALSE(one_point_rule(find_filter("db4"), bits).next_error.contains_zero());
  EXPECT_EQ(one_point_rule(find_filter("haar"), bits).degree, 1);
  const QuadratureRule spline = one_point_rule(find_filter("bspline3.3"), bits);
  EXPECT_EQ(spline.degree, 1);
  EXPECT_TRUE(spline.next_error.contains(Rational(1, 4)));
}

TEST(Quadrature, ShiftsReproducePolynomials) {
  const WorkingPrecision precision(bits);
  for (const std::string name : {"db4", "cdf9.7", "bspline3.3"}) {
    const FilterDefinition definition = find_filter(name);
    const auto a = reproduction_coefficients(definition, bits);
    const auto values = dyadic_values(definition, {}, 1, bits);
    ASSERT_GE(a.size(), 3U);
    // x^2 = sum_l (l^2 + 2 l a_1 + a_2) phi(x - l) at x = 7/2, which is the place 7 of the values.
    Ball sum(0);
    for (int l = -20; l <= 20; ++l) {
      sum += (Ball(l * l) + Ball(2 * l) * a[1] + a[2]) * values[7 - 2 * l];
    }
    EXPECT_TRUE(sum.contains(Rational(49, 4))) << name;
    EXPECT_LT(sum.radius_double(), 1e-25);
  }
}

TEST(Quadrature, RefusesBadRules) {
  const FilterDefinition db3 = find_filter("db3");
  EXPECT_THROW(equidistant_rule(db3, Rational(0), Rational(1), 0, bits), std::invalid_argument);
  EXPECT_THROW(equidistant_rule(db3, Rational(0), Rational(1), 41, bits), std::invalid_argument);
  EXPECT_THROW(equidistant_rule(db3, Rational(0), Rational(0), 3, bits), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::certified
