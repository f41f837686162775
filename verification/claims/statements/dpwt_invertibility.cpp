// "It have been shown by Getz that the DPWT is perfectly invertible when applied to sequences of
// finite length": in exact arithmetic an identity, here the rounding that is left of it, of every
// family, on all levels of a sequence, most of them shorter than the longer filters.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "wavecurve/filters/filter_tables.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/periodic_transform.hpp"
#include "wavecurve/transform/synthesis_matrix.hpp"

#include "verification/suite/claim.hpp"

namespace wavecurve::verification::dpwt_invertibility_claim {

namespace {

constexpr int samples = 256, levels = 8, sequences = 8;
constexpr double unit = std::numeric_limits<double>::epsilon();
/// A level errs by a few roundings of the norm in each direction.
constexpr double allowed_units_per_level = 4;

Eigen::VectorXd random_sequence(std::mt19937_64& generator) {
  Eigen::VectorXd x(samples);
  for (double& value : x) value = std::ldexp(static_cast<double>(generator() >> 11), -52) - 1;
  return x;
}

/// Summed in order, so that the figure is the same on every machine.
double norm(const Eigen::VectorXd& x) {
  double sum = 0;
  for (double value : x) sum += value * value;
  return std::sqrt(sum);
}

/// |inverse(forward(x)) - x| / |x| in units of 2^-52 a level, the largest of several sequences.
double units_per_level(const FilterBank<double>& bank) {
  const PeriodicTransform<double> transform(bank, samples, levels);
  std::mt19937_64 generator;
  Eigen::VectorXd y(samples), z(samples), workspace(transform.workspace_size());
  double worst = 0;
  for (int i = 0; i < sequences; ++i) {
    const Eigen::VectorXd x = random_sequence(generator);
    transform.forward(x, y, workspace);
    transform.inverse(y, z, workspace);
    worst = std::max(worst, norm(z - x) / norm(x) / unit / levels);
  }
  return worst;
}

/// The tables' families, without the reversed pairs, whose transform is the transpose of another's
/// inverse, and those that are computed from their names.
std::vector<std::string> families() {
  std::vector<std::string> names;
  for (const FilterTableRow& row : filter_table_rows()) {
    if (!row.name.starts_with("rbio")) names.emplace_back(row.name);
  }
  for (const char* orders :
       {"2.2", "2.4", "2.6", "2.8", "3.1", "3.3", "3.5", "3.7", "3.9", "4.4"}) {
    names.push_back(std::string("bspline") + orders);
  }
  return names;
}

/// |S| |S^-1| of the synthesis matrix: what rounding in the coefficients is enlarged by.
double condition(const FilterBank<double>& bank) {
  if (bank.is_orthonormal()) return 1;
  const Eigen::MatrixXd s = synthesis_matrix(bank, samples, levels);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(s.transpose() * s,
                                                              Eigen::EigenvaluesOnly);
  return std::sqrt(solver.eigenvalues().maxCoeff() / solver.eigenvalues().minCoeff());
}

Outcome evaluate() {
  Table table{fmt::format("Round trip of random sequences, N = {}, {} levels, double: |error| / "
                          "|x| in units of 2^-52 a level",
                          samples, levels),
              {"filter", "orthonormal", "condition", "units a level", "allowed"},
              {}};
  double worst_orthonormal = 0, worst_other = 0;
  bool holds = true;
  for (const std::string& name : families()) {
    const FilterBank<double> bank = find_filter_bank<double>(name);
    const double units = units_per_level(bank), enlarged = condition(bank);
    const double allowed = allowed_units_per_level * enlarged;
    holds = holds && units <= allowed;
    double& worst = bank.is_orthonormal() ? worst_orthonormal : worst_other;
    worst = std::max(worst, units);
    table.rows.push_back({bank.name, bank.is_orthonormal() ? "yes" : "no",
                          fmt::format("{:.3g}", enlarged), fmt::format("{:.2g}", units),
                          fmt::format("{:.3g}", allowed)});
  }
  Outcome outcome;
  outcome.verdict = holds ? ClaimVerdict::holds : ClaimVerdict::does_not_hold;
  const auto error = [](const std::string& families, double units) {
    return to_digits("largest error of a round trip, " + families, units, 2,
                     "units of 2^-52 a level");
  };
  outcome.finding = {
      "round trip: at most {} for orthonormal families, {} for the biorthogonal ones",
      {error("orthonormal families", worst_orthonormal),
       error("biorthogonal families", worst_other)}};
  outcome.summary =
      "Forward and back gives the sequence again up to rounding, for every family and also where "
      "the sequence is shorter than the filter. The biorthogonal families enlarge rounding by at "
      "most the condition of their basis.";
  outcome.evidence = {table};
  return outcome;
}

const RegisterClaim registered(
    {"dpwt-invertibility", "The discrete periodic wavelet transform is perfectly invertible",
     "Section 2.1, after (2.9)",
     "It have been shown by Getz that the DPWT is perfectly invertible when applied to sequences "
     "of finite length.",
     evaluate});

}  // namespace

}  // namespace wavecurve::verification::dpwt_invertibility_claim
