#include "wavecurve/integrals/periodic.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/integrals/product_integrals.hpp"

namespace wavecurve {
namespace {

constexpr BasisFunction phi{}, slope{.derivative = 1};
constexpr double tolerance = 1e-12;  // sums of a hundred numbers of unit size

TEST(PeriodicIntegrals, AreThoseOfTheLineForConstants) {
  // With period 1 phi is the constant 1, by the partition of unity, and phi' is 0.
  for (const std::string name : {"db3", "cdf9.7"}) {
    const auto bank = find_filter_bank(name);
    const auto mass = periodized(product_integrals(bank, {{{phi, false}, {phi}, {phi}}}), 1);
    ASSERT_EQ(mass.values.size(), 1U);
    EXPECT_NEAR(mass.values[0], 1, tolerance);
    const auto advection = periodized(product_integrals(bank, {{{slope, false}, {phi}, {phi}}}), 1);
    EXPECT_NEAR(advection.values[0], 0, tolerance);
  }
}

TEST(PeriodicIntegrals, AreTheIntegralsOfPeriodicFunctions) {
  // Period 4 is less than the support 5 of D6: hats of period 2 instead, where phi_2(x - 1) = 1 -
  // phi_2(x).
  const auto bank = find_filter_bank("bspline2.2");
  const auto mass = periodized(product_integrals(bank, {{{phi, false}, {phi}, {phi}}}), 2);
  EXPECT_NEAR(mass.at({0, 0}), 1.0 / 2, tolerance);            // int_{-1}^1 hat^3
  EXPECT_NEAR(mass.at({0, 1}), 2.0 / 3 - 1.0 / 2, tolerance);  // int hat^2 (1 - hat)
  EXPECT_NEAR(mass.at({1, 1}), 1 - 4.0 / 3 + 1.0 / 2, tolerance);
}

TEST(PeriodicIntegrals, TheBilinearFormIsTheSumOfThePeriodizedIntegrals) {
  const auto integrals =
      product_integrals(find_filter_bank("db3"), {{{slope, false}, {phi}, {phi}}});
  for (const int n : {1, 3, 7, 16}) {  // below the width of the integrals, and above
    const auto wrapped = periodized(integrals, n);
    Eigen::VectorXd u(n), v(n);
    for (int i = 0; i < n; ++i) {
      u[i] = std::sin(1 + i);
      v[i] = std::cos(3.0 * i);
    }
    const Eigen::VectorXd w = periodic_bilinear_form(integrals, u, v);
    for (int i = 0; i < n; ++i) {
      double sum = 0;
      for (int l = 0; l < n; ++l) {
        for (int m = 0; m < n; ++m) sum += wrapped.at({l, m}) * u[(i + l) % n] * v[(i + m) % n];
      }
      EXPECT_NEAR(w[i], sum, tolerance);
    }
  }
  EXPECT_THROW(periodic_bilinear_form(integrals, Eigen::VectorXd(3), Eigen::VectorXd(4)),
               std::invalid_argument);
}

TEST(PeriodicIntegrals, TheProductRuleHoldsForTheBilinearForm) {
  // int phi'(x - i) u^2 = -2 int phi(x - i) u u': u = e^(sin) samples.
  const auto bank = find_filter_bank("db4");
  const auto flux = product_integrals(bank, {{{slope, false}, {phi}, {phi}}});
  const auto convection = product_integrals(bank, {{{phi, false}, {phi}, {slope}}});
  Eigen::VectorXd u(32);
  for (int i = 0; i < 32; ++i) u[i] = std::exp(std::sin(2 * std::numbers::pi * i / 32));
  const Eigen::VectorXd difference =
      periodic_bilinear_form(flux, u, u) + 2 * periodic_bilinear_form(convection, u, u);
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 100 * tolerance);
}

}  // namespace
}  // namespace wavecurve
