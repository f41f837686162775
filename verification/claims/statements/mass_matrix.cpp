// "the mass matrix M = ρ I" (section 3.2), "by using the orthogonality property of the scaling
// and wavelet functions"; the publication also uses the biorthogonal cubic B-splines, which have
// none.
#include <algorithm>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/connection_coefficients.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/operators/spectrum.hpp"

#include "verification/suite/claim.hpp"

namespace wavecurve::verification::mass_matrix_claim {

namespace {

constexpr int samples = 64;

/// The largest entry of |M - I|; M from the integrals, without the knowledge that it is I.
double distance_to_identity(const FilterBank<double>& bank, int levels) {
  const Eigen::MatrixXd mass = multiscale_matrix(bank, samples, levels, 0, 0);
  return (mass - Eigen::MatrixXd::Identity(samples, samples)).cwiseAbs().maxCoeff();
}

Outcome evaluate() {
  Table table{
      fmt::format("Largest entry of |M - I|, ρ = 1, and the eigenvalues of M; N = {}", samples),
      {"filter", "orthonormal", "single scale", "two levels", "all levels",
       "smallest eigenvalue, all levels", "largest"},
      {}};
  // Integrals and two transforms of six levels, some 40 roundings each.
  const double tolerance = 16 * 40 * std::numeric_limits<double>::epsilon();
  double orthonormal = 0, smallest_other = std::numeric_limits<double>::infinity();
  for (const char* name : {"haar", "db2", "db4", "db10", "sym8", "coif1", "coif2", "bspline2.2",
                           "bspline3.3", "bspline4.4", "cdf9.7"}) {
    const FilterBank<double> bank = find_filter_bank<double>(name);
    double worst = 0;
    std::vector<std::string> row{name, bank.is_orthonormal() ? "yes" : "no"};
    for (int levels : {0, 2, 6}) {
      const double distance = distance_to_identity(bank, levels);
      worst = std::max(worst, distance);
      row.push_back(distance <= tolerance ? fmt::format("below {:.0e}", tolerance)
                                          : fmt::format("{:.4f}", distance));
    }
    const ExtremeEigenvalues ends = extreme_eigenvalues(bank, samples, 6, 0);
    row.push_back(fmt::format("{:.5g}", ends.smallest));
    row.push_back(fmt::format("{:.5g}", ends.largest));
    table.rows.push_back(row);
    if (bank.is_orthonormal()) {
      orthonormal = std::max(orthonormal, worst);
    } else {
      smallest_other = std::min(smallest_other, worst);
    }
  }
  const bool holds_there = orthonormal <= tolerance, holds_elsewhere = smallest_other <= tolerance;
  Outcome outcome;
  outcome.verdict = holds_there == holds_elsewhere
                        ? (holds_there ? ClaimVerdict::holds : ClaimVerdict::does_not_hold)
                        : ClaimVerdict::depends_on_definition;
  outcome.finding = {
      fmt::format("largest entry of |M - I|: below {:.0e} for orthonormal, at least {{}} for "
                  "biorthogonal families",
                  tolerance),
      {to_decimals("smallest |M - I| of a biorthogonal family", smallest_other, 2),
       to_digits("largest |M - I| of the orthonormal families", orthonormal, 1)
           .within(tolerance,
                   "The integrals and two transforms of six levels are rounded some 40 times.")}};
  outcome.summary =
      "M = ρ I is true of the orthonormal families and of no other one of the table; for the "
      "cubic "
      "B-splines, which section 2 uses, M couples neighbours as well as levels.";
  outcome.evidence = {table};
  return outcome;
}

const RegisterClaim registered({"mass-matrix", "The mass matrix is a multiple of the identity",
                                "Section 3.2", "the mass matrix M = ρI", evaluate});

}  // namespace

}  // namespace wavecurve::verification::mass_matrix_claim
