// Figure 3 plots the stiffness matrix of the Coiflet K_2, 64 x 64, for two scales.
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/matrix_picture.hpp"
#include "wavecurve/operators/connection_coefficients.hpp"
#include "wavecurve/operators/matrix_measures.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/transform/bands.hpp"

#include "verification/suite/claim.hpp"

namespace wavecurve::verification::figure_3 {

namespace {

constexpr int samples = 64, levels = 2;

std::string with_share(Eigen::Index count) {
  return fmt::format("{} ({:.1f} %)", count,
                     100.0 * static_cast<double>(count) / (samples * samples));
}

std::vector<std::string> row(std::string_view what, const Eigen::SparseMatrix<double>& k) {
  return {std::string(what), with_share(k.nonZeros()), with_share(count_above(k, 1e-12)),
          fmt::format("{:.2g}", symmetry_error(k))};
}

Outcome evaluate() {
  const FilterBank<double> bank = find_filter_bank<double>("coif2");
  const auto coefficients = connection_coefficients(bank, 1, 1);
  const auto k = multiscale_matrix(bank, coefficients, samples, levels);
  const Eigen::MatrixXd twin = plain::multiscale_matrix(bank, coefficients, samples, levels);
  const double asymmetry = symmetry_error(twin.sparseView());
  const double difference =
      (Eigen::MatrixXd(k) - twin).cwiseAbs().maxCoeff() / twin.cwiseAbs().maxCoeff();
  // Two products of 64 x 64 matrices round each entry up to 128 times.
  const bool agree =
      std::max(difference, asymmetry) <= 128 * std::numeric_limits<double>::epsilon();

  Picture picture;
  picture.id = "figure-3";
  picture.alternative_text = fmt::format(
      "Magnitudes of the {0} x {0} stiffness matrix of K2: a band along the diagonal of each of "
      "the "
      "three blocks, and oblique bands in the blocks between levels; {1} entries are not zero.",
      samples, k.nonZeros());
  picture.svg = io::matrix_picture(
      k, band_borders(samples, levels),
      {fmt::format("Stiffness matrix K of K2, {0} x {0}, two scales", samples),
       picture.alternative_text, "magnitude of the entry (e_0 = 1, unit interval)"});
  picture.data = {"Entries of K for K2, N = 64",
                  {"decomposition", "non-zeros", "above 1e-12 of the largest", "symmetry error"},
                  {row("two wavelet levels (the figure)", k),
                   row("one wavelet level", stiffness(bank, samples, 1)),
                   row("single scale", stiffness(bank, samples, 0)),
                   row("all six levels", stiffness(bank, samples, 6))}};
  return {
      agree ? ClaimVerdict::holds : ClaimVerdict::does_not_hold,
      {"{} of {} entries are not zero, {} of them above 1e-12 of the largest; symmetry error {}",
       {counted("entries that are not zero", k.nonZeros()), counted("entries", samples * samples),
        counted("entries above 1e-12 of the largest", count_above(k, 1e-12)),
        to_digits("symmetry error", symmetry_error(k), 2)}},
      fmt::format("The matrix is symmetric, with the block structure of the figure. Assembled "
                  "from the connection coefficients and computed by the definition S^T K S it "
                  "differs by {:.0e} of its largest entry.",
                  difference),
      {picture}};
}

const RegisterClaim registered(
    {"figure-3", "Stiffness matrix of K2 for two scales", "Section 3.2, Figure 3",
     "Stiffness matrix K of the K_2 Coiflet wavelet. The case of two scale (M = 2) is shown.",
     evaluate});

}  // namespace

}  // namespace wavecurve::verification::figure_3
