#include "wavecurve/transform/dyadic_values.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/refinable.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A value is a sum of as many products as there are taps, at points that are reached through an
/// elimination: a few units for each tap, of the largest value. Each derivative divides the mask by
/// (1 + z) / 2, an alternating sum of up to half of the taps, which adds up their errors.
double tolerance(const FilterBank<double>& bank, const Eigen::VectorXd& values, int d) {
  const double taps = bank.synthesis_low.size();
  return 4 * taps * std::pow(taps / 2, d) * epsilon * values.cwiseAbs().maxCoeff();
}

struct Case {
  const char* name;
  int largest_derivative;
};
const Case cases[] = {{"db2", 0},        {"db3", 1},    {"db4", 1},   {"db10", 3},
                      {"db38", 3},       {"sym8", 2},   {"coif1", 0}, {"coif2", 1},
                      {"bspline4.4", 2}, {"cdf9.7", 1}, {"coif17", 3}};

TEST(ScalingValues, AreTheCertifiedOnesAtTheIntegers) {
  for (const Case& c : cases) {
    const FilterBank<double> bank = find_filter_bank<double>(c.name);
    for (int d = 0; d <= c.largest_derivative; ++d) {
      const certified::WorkingPrecision precision(512);
      auto mask = certified::find_filter(c.name).bank(512).synthesis_low;
      for (auto& tap : mask.taps) tap *= sqrt(certified::Ball(2));
      const auto expected = certified::derivative_at_integers(mask, d);
      const DyadicValues phi = scaling_values(bank, 3, d);
      for (int l = mask.first_index; l <= mask.last_index(); ++l) {
        const auto i = static_cast<Eigen::Index>((l - phi.first) * 8);
        EXPECT_NEAR(phi.values[i], expected[l].to_double(), tolerance(bank, phi.values, d))
            << c.name << " " << d << " at " << l;
      }
    }
  }
}

TEST(ScalingValues, AreThePolynomialsOfTheCubicSpline) {
  const DyadicValues phi = scaling_values(find_filter_bank<double>("bspline4.4"), 6);
  const auto power = [](double x) { return x > 0 ? x * x * x : 0; };
  for (Eigen::Index i = 0; i < phi.values.size(); ++i) {
    const double x = phi.point(i) - phi.first;
    const double expected =
        (power(x) - 4 * power(x - 1) + 6 * power(x - 2) - 4 * power(x - 3) + power(x - 4)) / 6;
    EXPECT_NEAR(phi.values[i], expected, 64 * epsilon) << x;  // terms up to 64 / 6 cancel
  }
}

/// sum_l phi(x - l) = 1, and its derivatives vanish, at every point of a fine grid.
TEST(ScalingValues, AddUpToOneOverAllShifts) {
  constexpr int level = 8;
  for (const Case& c : cases) {
    const FilterBank<double> bank = find_filter_bank<double>(c.name);
    for (int d = 0; d <= c.largest_derivative; ++d) {
      const Eigen::VectorXd phi = scaling_values(bank, level, d).values;
      for (Eigen::Index r = 0; r < 1 << level; ++r) {
        double sum = 0;
        for (Eigen::Index i = r; i < phi.size(); i += 1 << level) sum += phi[i];
        EXPECT_NEAR(sum, d == 0 ? 1 : 0, bank.synthesis_low.size() * tolerance(bank, phi, d))
            << c.name << " " << d;
      }
    }
  }
}

/// The trapezoidal rule: the derivative of order d adds up to differences of the one below.
TEST(WaveletValues, IntegrateToTheWaveletForADerivative) {
  constexpr int level = 12;
  for (const char* name : {"db4", "db10", "bspline4.4", "cdf9.7"}) {
    const FilterBank<double> bank = find_filter_bank<double>(name);
    const DyadicValues psi = wavelet_values(bank, level), slope = wavelet_values(bank, level, 1);
    ASSERT_EQ(psi.values.size(), slope.values.size());
    EXPECT_EQ(psi.first, slope.first);
    double integral = 0;
    // phi' is Hoelder continuous with exponent 0.6 or more: the rule errs by about h^0.6 h a step.
    const double error = 2 * std::pow(2.0, -0.6 * level) * slope.values.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 1; i < psi.values.size(); ++i) {
      integral += std::ldexp(slope.values[i - 1] + slope.values[i], -level - 1);
      EXPECT_NEAR(integral, psi.values[i], error) << name;
    }
    EXPECT_NEAR(psi.values.sum(), 0, std::ldexp(epsilon, level) * 64) << name;
  }
}

TEST(WaveletValues, AreThoseOfCoarserGridsAtTheirPoints) {
  for (const char* name : {"db4", "coif2", "bspline3.3"}) {
    const FilterBank<double> bank = find_filter_bank<double>(name);
    const DyadicValues fine = wavelet_values(bank, 3);
    for (int level : {0, 1, 2}) {
      const DyadicValues coarse = wavelet_values(bank, level);
      for (Eigen::Index i = 0; i < coarse.values.size(); ++i) {
        const auto at = static_cast<Eigen::Index>((coarse.point(i) - fine.first) * 8);
        EXPECT_EQ(coarse.values[i], fine.values[at]) << name << " " << level;
      }
    }
  }
}

TEST(DyadicValues, RefuseWhatIsNoFunction) {
  const auto bank = [](const char* name) { return find_filter_bank<double>(name); };
  EXPECT_THROW(scaling_values(bank("haar"), 3), std::domain_error);
  EXPECT_THROW(scaling_values(bank("db2"), 3, 1), std::domain_error);
  EXPECT_THROW(wavelet_values(bank("db4"), 3, 2), std::domain_error);
  EXPECT_THROW(scaling_values(bank("db4"), -1), std::invalid_argument);
  EXPECT_THROW(scaling_values(bank("db4"), 25), std::invalid_argument);
  EXPECT_THROW(scaling_values(bank("db4"), 3, -1), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
