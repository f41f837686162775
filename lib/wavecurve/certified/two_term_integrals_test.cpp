#include "wavecurve/certified/two_term_integrals.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"

namespace wavecurve::certified {
namespace {

constexpr long bits = 128;
constexpr BasisFunction phi{}, psi{.wavelet = true};

BasisFunction derived(BasisFunction f, int order) {
  f.derivative = order;
  return f;
}

TEST(TwoTermIntegrals, AgreeWithMuAndNu) {
  const WorkingPrecision precision(bits);
  for (const std::string name : {"db3", "db6", "coif2", "bspline4.4", "cdf9.7"}) {
    const FilterDefinition definition = find_filter(name);
    for (const auto& [p, q] : {std::pair{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
      const auto known = connection_coefficients(definition, p, q, bits);
      // mu_l = int phi^(p)(x - l) phi^(q)(x): the factor at rest comes first here.
      const auto low = two_term_integrals(definition, derived(phi, q), derived(phi, p), bits);
      const auto high = two_term_integrals(definition, derived(psi, q), derived(psi, p), bits);
      for (int l = -30; l <= 30; ++l) {
        EXPECT_TRUE(low[l].overlaps(known.mu[l])) << name << " " << p << q << " " << l;
        EXPECT_TRUE(high[l].overlaps(known.nu[l])) << name << " " << p << q << " " << l;
      }
    }
  }
}

TEST(TwoTermIntegrals, HaveBeylkinsExactValuesForD6) {
  const auto r = two_term_integrals(find_filter("db3"), derived(phi, 1), phi, bits);
  const Rational known[] = {Rational(0), Rational(-272, 365), Rational(53, 365),
                            Rational(-16, 1095), Rational(-1, 2920)};
  for (int l = 0; l <= 4; ++l) {
    // int phi'(x) phi(x - l) dx; Beylkin's r_l is positive at l = -1.
    EXPECT_TRUE(r[l].contains(known[l]) || r[-l].contains(known[l])) << l;
    EXPECT_TRUE((r[l] + r[-l]).contains_zero());
  }
}

TEST(TwoTermIntegrals, IntegrateByParts) {
  for (const std::string name : {"db5", "bspline4.4"}) {
    const FilterDefinition definition = find_filter(name);
    const auto once = two_term_integrals(definition, derived(phi, 1), derived(psi, 1), bits);
    const auto twice = two_term_integrals(definition, phi, derived(psi, 2), bits);
    for (int l = -12; l <= 12; ++l) EXPECT_TRUE((once[l] + twice[l]).contains_zero()) << l;
  }
}

TEST(TwoTermIntegrals, TheTwoSidesAreBiorthogonal) {
  constexpr BasisFunction dual_phi{.dual = true};
  const FilterDefinition definition = find_filter("cdf9.7");
  const auto delta = two_term_integrals(definition, phi, dual_phi, bits);
  const auto zero = two_term_integrals(definition, psi, dual_phi, bits);
  for (int l = -8; l <= 8; ++l) {
    EXPECT_TRUE(delta[l].contains(Rational(l == 0 ? 1 : 0))) << l;
    EXPECT_TRUE(zero[l].contains_zero()) << l;
    EXPECT_LT(delta[l].radius_double(), 1e-30);
  }
}

TEST(TwoTermIntegrals, DerivativesOfAScalingFunctionActOnPolynomials) {
  // sum_l l^2 phi(x - l) = x^2 + .., and its second derivative is 2: int phi 2 = 2.
  const auto values = two_term_integrals(find_filter("db4"), phi, derived(phi, 2), bits);
  Ball sum(0);
  for (int l = -10; l <= 10; ++l) sum += Ball(l * l) * values[l];
  EXPECT_TRUE(sum.contains(Rational(2)));
}

TEST(TwoTermIntegrals, RefuseWhatDoesNotExist) {
  EXPECT_THROW(two_term_integrals(find_filter("db2"), derived(phi, 1), derived(psi, 1), bits),
               std::domain_error);
  EXPECT_THROW(two_term_integrals(find_filter("db9"), derived(phi, 9), phi, bits),
               std::invalid_argument);
  EXPECT_THROW(
      two_term_integrals(find_filter("bspline3.1"), phi, {.dual = true, .derivative = 3}, bits),
      std::domain_error);
}

}  // namespace
}  // namespace wavecurve::certified
