// "The Bezier curves can be converted into the hierarchical wavelet description by performing even
// sampling and wavelet transforms on the curves": the samples are put in the place of the finest
// coefficients c_n^{M_f} of (2.5). How far is the curve (2.5) of those from the outline?
#include <cmath>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/curves/hausdorff_distance.hpp"
#include "wavecurve/curves/interpolation.hpp"
#include "wavecurve/curves/wavelet_curve.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"

#include "verification/stand_ins/example_contour.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification::samples_as_coefficients_claim {

namespace {

constexpr const char* daubechies = "db4";
constexpr const char* centred = "coif2";
constexpr Eigen::Index most_samples = 1024;

/// Relative to the diagonal of the bounding box.
struct Errors {
  double same_parameter = 0;  ///< RMS, curve at n / N against sample n
  double shifted = 0;         ///< RMS, curve at (n + m) / N, m the centre of phi
  double outline = 0;         ///< Hausdorff
};

/// The curve at (n + offset) / N, row n.
Contour points_of(const FilterBank<double>& bank, const Contour& finest, double offset) {
  const WaveletCurve curve(bank, finest);
  const Eigen::Index count = finest.rows();
  Contour points(count, 2);
  for (Eigen::Index n = 0; n < count; ++n) {
    points.row(n) = curve.point((static_cast<double>(n) + offset) / static_cast<double>(count));
  }
  return points;
}

Errors errors_of(const FilterBank<double>& bank, const Contour& digit) {
  const Contour shifted = points_of(bank, digit, centre_of_phi(bank));
  const double unit = diagonal(digit);
  return {rms_distance(values_at_integers(bank, digit), digit) / unit,
          rms_distance(shifted, digit) / unit, hausdorff_distance(shifted, digit) / unit};
}

std::string interpolation_cell(const FilterBank<double>& bank, const Contour& digit) {
  constexpr double rounding = 1e-14;  // a few dozen operations on each sample, on any machine
  try {
    const Contour finest = interpolate(bank, digit);
    const double error = rms_distance(values_at_integers(bank, finest), digit) / diagonal(digit);
    return error < rounding ? "below 1e-14" : fmt::format("{:.1g}", error);
  } catch (const std::domain_error&) {
    return fmt::format("refused: smallest symbol {:.3f}", smallest_symbol(bank, digit.rows()));
  }
}

/// Without the sign of a zero that rounding leaves.
std::string four_decimals(double value) {
  return fmt::format("{:.4f}", std::round(1e4 * value) / 1e4 + 0.0);
}

Outcome evaluate() {
  Table table{
      "The digit 3: distance of the curve (2.5) from the outline, in % of the diagonal of "
      "its bounding box, if its samples are taken as coefficients",
      {"filter", "samples", "RMS at n/N", "phi's centre m", "RMS at (n + m)/N", "Hausdorff",
       "interpolated: RMS/diagonal"},
      {}};
  Errors coarse, fine, coiflet;
  for (const char* name : {"db2", "db4", "db10", "sym4", "sym8", "coif1", "coif2", "bspline2.2",
                           "bspline3.3", "bspline4.4", "cdf9.7"}) {
    const FilterBank<double> bank = find_filter_bank<double>(name);
    for (const Eigen::Index samples : {Eigen::Index{64}, Eigen::Index{256}, most_samples}) {
      const Contour digit = example_contour("three.svg", samples);
      const Errors errors = errors_of(bank, digit);
      if (bank.name == daubechies && samples == 64) coarse = errors;
      if (bank.name == daubechies && samples == most_samples) fine = errors;
      if (bank.name == centred && samples == most_samples) coiflet = errors;
      table.rows.push_back(
          {bank.name, std::to_string(samples), fmt::format("{:.4f}", 100 * errors.same_parameter),
           four_decimals(centre_of_phi(bank)), fmt::format("{:.5f}", 100 * errors.shifted),
           fmt::format("{:.5f}", 100 * errors.outline), interpolation_cell(bank, digit)});
    }
  }
  Outcome outcome;
  outcome.verdict = ClaimVerdict::depends_on_definition;
  outcome.finding = {
      "D8, {} samples: off by {} of the diagonal at equal parameters, by {} as an outline",
      {counted("samples", most_samples),
       to_digits("RMS distance at equal parameters", 100 * fine.same_parameter, 2, "%"),
       to_digits("distance as an outline", 100 * fine.outline, 1, "%")}};
  outcome.summary = fmt::format(
      "With its samples as coefficients the curve is late by phi's centre: at equal parameters it "
      "is off by {:.2g} % of the diagonal (D8, 1024 samples; {:.2g} % for 64), as an outline by "
      "{:.1g} % ({:.2g} %) only. Coiflets are not late, since m = 0: K2 is off by {:.1g} %. The "
      "coefficients of the curve through the samples leave rounding.",
      100 * fine.same_parameter, 100 * coarse.same_parameter, 100 * fine.outline,
      100 * coarse.outline, 100 * coiflet.same_parameter);
  outcome.evidence = {table};
  return outcome;
}

const RegisterClaim registered(
    {"samples-as-coefficients", "Even samples of a curve as its finest wavelet coefficients",
     "Sections 2.2 and 4.1",
     "The Bezier curves can be converted into the hierarchical wavelet description by performing "
     "even sampling and wavelet transforms on the curves.",
     evaluate});

}  // namespace

}  // namespace wavecurve::verification::samples_as_coefficients_claim
