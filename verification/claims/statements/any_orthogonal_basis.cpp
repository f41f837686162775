// "This method can however be applied to any other orthogonal wavelet bases": only where phi' is
// square integrable. Haar's and Daubechies' D4 are orthonormal and have no stiffness.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/certified/sobolev_exponent.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/dyadic_values.hpp"

#include "verification/suite/claim.hpp"

namespace wavecurve::verification::any_orthogonal_basis_claim {

namespace {

using certified::Ball;

constexpr int finest_level = 14;

/// int (difference quotient)^2 of phi at the spacings 2^-1 .. 2^-finest_level.
std::vector<double> stiffness_by_level(const std::string& name) {
  const Eigen::VectorXd phi = scaling_values(find_filter_bank(name), finest_level).values;
  std::vector<double> energies;
  for (int level = 1; level <= finest_level; ++level) {
    const Eigen::Index step = Eigen::Index{1} << (finest_level - level);
    double sum = 0;
    for (Eigen::Index i = step; i < phi.size(); i += step) {
      sum += (phi[i] - phi[i - step]) * (phi[i] - phi[i - step]);
    }
    energies.push_back(std::ldexp(sum, level));
  }
  return energies;
}

Table exponents() {
  Table table{"Sobolev exponents s of orthonormal families; stiffness needs s > 1",
              {"filter", "s (certified)", "stiffness μ_0"},
              {}};
  for (const char* name : {"db1", "db2", "db3", "db4", "sym4", "coif1", "coif2"}) {
    const auto definition = certified::find_filter(name);
    const std::string s = *round_to_digits(sobolev_exponent(definition), 6);
    std::string mu = "infinite";
    try {
      mu = *round_to_digits(connection_coefficients(definition, 1, 1, 64).mu[0], 6);
    } catch (const std::domain_error&) {
    }
    table.rows.push_back({name, s, mu});
  }
  return table;
}

Outcome evaluate() {
  const auto d4 = stiffness_by_level("db2"), d6 = stiffness_by_level("db3");
  Chart chart{
      "stiffness-of-d4",
      {"Integral of the squared difference quotient of φ, by spacing 2^-level",
       {"level", "D4", "D6"},
       {}},
      "set xlabel 'level (spacing 2^{-level})'\n"
      "set ylabel 'integral of squared difference quotient'\n"
      "set key left top\n"
      "plot data using 1:2 with linespoints lt -1 pt 7 title 'D4 (s = 1): grows without bound', "
      "data using 1:3 with linespoints lt -1 dt 2 pt 6 title 'D6 (s = 1.415): converges'\n"};
  for (int level = 1; level <= finest_level; ++level) {
    const auto i = static_cast<std::size_t>(level - 1);
    chart.data.rows.push_back(
        {std::to_string(level), fmt::format("{:.6f}", d4[i]), fmt::format("{:.6f}", d6[i])});
  }
  const std::size_t last = d4.size() - 1;
  const double d4_step = d4[last] - d4[last - 1], d6_step = d6[last] - d6[last - 1];
  const auto s = sobolev_exponent(certified::find_filter("D4"));
  const bool refused = !certainly_less(Ball(1), s);
  Outcome outcome;
  outcome.verdict = refused ? ClaimVerdict::does_not_hold : ClaimVerdict::holds;
  outcome.finding = {"D4: exponent {}, stiffness infinite",
                     {to_decimals("Sobolev exponent of D4", std::stod(*round_to_digits(s, 4)), 3)}};
  outcome.summary = fmt::format(
      "The integrals of φ' φ' exist only for a Sobolev exponent above 1. Haar's and D4 are "
      "orthonormal and have none: refining the grid once more adds {:.3f} to D4's energy at level "
      "{}, "
      "as at every level before, and {:.1e} to D6's.",
      d4_step, finest_level, d6_step);
  outcome.evidence = {exponents(), chart};
  return outcome;
}

const RegisterClaim registered(
    {"any-orthogonal-basis", "The method applies to any orthogonal wavelet basis",
     "Section 3.2, after (3.14)",
     "This method can however be applied to any other orthogonal wavelet bases.", evaluate});

}  // namespace

}  // namespace wavecurve::verification::any_orthogonal_basis_claim
