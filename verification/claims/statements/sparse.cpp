// "K and C with respect to the wavelet representation is sparse" (section 3.2, and the abstract).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/elementary/logarithm.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/matrix_measures.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

#include "verification/suite/claim.hpp"

namespace wavecurve::verification::sparse_claim {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

constexpr int published_samples = 64;
/// What "sparse" is taken to mean: of a matrix, that fewer than a quarter of its entries are not
/// zero; of a family of matrices, that the non-zeros grow more slowly than N^1.5.
constexpr double sparse_share = 0.25, sparse_exponent = 1.5;
/// Entries below this fraction of the largest are not told from zero.
constexpr double rounding = 1e-12;

double share(const Matrix& k) {
  return static_cast<double>(k.nonZeros()) / static_cast<double>(k.size());
}

/// Entries above a fraction of the largest, as a share of all.
double share_above(const Matrix& k, double fraction) {
  return static_cast<double>(count_above(k, fraction)) / static_cast<double>(k.size());
}

Table at_published_size() {
  Table table{fmt::format("N = {}: non-zeros, and the entries above a fraction of the largest",
                          published_samples),
              {"filter", "wavelet levels", "non-zeros", "share, %", "above 1e-12, %",
               "above 1e-6, %", "above 1e-3, %"},
              {}};
  for (const char* name : {"db3", "db4", "coif1", "coif2", "db10", "bspline4.4"}) {
    const FilterBank<double> bank = find_filter_bank<double>(name);
    for (int levels : {0, 1, 2, all_levels(published_samples)}) {
      const Matrix k = stiffness(bank, published_samples, levels);
      table.rows.push_back({name, std::to_string(levels), std::to_string(k.nonZeros()),
                            fmt::format("{:.1f}", 100 * share(k)),
                            fmt::format("{:.1f}", 100 * share_above(k, rounding)),
                            fmt::format("{:.1f}", 100 * share_above(k, 1e-6)),
                            fmt::format("{:.1f}", 100 * share_above(k, 1e-3))});
    }
  }
  return table;
}

struct Range {
  double smallest = 1, largest = 0;
};

/// Over the publication's two filters and any number of wavelet levels; rounding does not count.
Range published_shares() {
  Range range;
  for (const char* name : {"db4", "coif2"}) {
    const FilterBank<double> bank = find_filter_bank<double>(name);
    for (int levels = 1; levels <= all_levels(published_samples); ++levels) {
      const double found = share_above(stiffness(bank, published_samples, levels), rounding);
      range.smallest = std::min(range.smallest, found);
      range.largest = std::max(range.largest, found);
    }
  }
  return range;
}

Chart by_size(double& last_exponent) {
  Chart chart;
  chart.id = "sparse-by-size";
  chart.data = {"Non-zeros with all levels; growth exponent against half the size",
                {"N", "D8", "K2", "D8 share, %", "D8 exponent", "dense"},
                {}};
  const FilterBank<double> d8 = find_filter_bank<double>("db4"),
                           k2 = find_filter_bank<double>("coif2");
  Eigen::Index last = 0;
  for (int samples = 16; samples <= 8192; samples *= 2) {
    const Matrix k = stiffness(d8, samples, all_levels(samples));
    const Eigen::Index other = stiffness(k2, samples, all_levels(samples)).nonZeros();
    const double exponent =
        logarithm(static_cast<double>(k.nonZeros()) / static_cast<double>(last)) /
        std::numbers::ln2;
    chart.data.rows.push_back({std::to_string(samples), std::to_string(k.nonZeros()),
                               std::to_string(other), fmt::format("{:.2f}", 100 * share(k)),
                               last == 0 ? "-" : fmt::format("{:.2f}", exponent),
                               std::to_string(k.size())});
    last = k.nonZeros();
    last_exponent = exponent;
  }
  chart.script =
      "set logscale xy 2\nset format y \"2^{%L}\"\nset format x \"2^{%L}\"\n"
      "set xlabel \"samples N\"\nset ylabel \"non-zeros\"\n"
      "plot for [i=2:3] data using 1:i with linespoints, data using 1:6 with lines\n";
  return chart;
}

Outcome evaluate() {
  double exponent = 0;
  const Chart chart = by_size(exponent);
  const Range range = published_shares();
  const bool sparse_there = range.largest < sparse_share,
             sparse_in_growth = exponent < sparse_exponent;
  Outcome outcome;
  outcome.verdict = sparse_there == sparse_in_growth
                        ? (sparse_there ? ClaimVerdict::holds : ClaimVerdict::does_not_hold)
                        : ClaimVerdict::depends_on_definition;
  outcome.finding = {
      "D8 and K2 at N = {}: {} to {} of the entries are not zero; for large N their number grows "
      "like N^{}",
      {counted("N", published_samples),
       to_decimals("smallest share of entries that are not zero", 100 * range.smallest, 0, "%"),
       to_decimals("largest share of entries that are not zero", 100 * range.largest, 0, "%"),
       to_decimals("exponent of their growth", exponent, 2)}};
  outcome.summary =
      "The non-zeros grow like N log N, so large matrices are sparse. At the size of the "
      "publication's figure the supports of the coarse functions cover the whole period, and the "
      "matrix is not.";
  outcome.evidence = {Paragraph{fmt::format(
                          "Taken as sparse: a matrix with fewer than {:.0f} % non-zeros; a family "
                          "of matrices whose non-zeros grow more slowly than N^{}.",
                          100 * sparse_share, sparse_exponent)},
                      at_published_size(), chart};
  return outcome;
}

const RegisterClaim registered({"sparse", "The stiffness matrix is sparse", "Abstract; section 3.2",
                                "K and C with respect to the wavelet representation is sparse",
                                evaluate});

}  // namespace

}  // namespace wavecurve::verification::sparse_claim
