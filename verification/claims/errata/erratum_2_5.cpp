// (2.5) sums the wavelets from m = M_f on. Its functions are written in the space one scale finer,
// where all of them have coefficients, so that their number, their rank and the coefficients of the
// finest wavelets can be computed.
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <fmt/core.h>

#include "wavecurve/filters/find_filter_bank.hpp"

#include "verification/suite/claim.hpp"

namespace wavecurve::verification::erratum_2_5 {

namespace {

/// Column n: the periodized function of (2.1), shifted by n at scale N = `columns`, in the basis of
/// the scaling functions at scale 2 N.
Eigen::MatrixXd two_scale_matrix(const Filter<double>& filter, int columns) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * columns, columns);
  for (int n = 0; n < columns; ++n) {
    for (int k = filter.first_index; k <= filter.last_index(); ++k) {
      const int wrapped = ((2 * n + k) % (2 * columns) + 2 * columns) % (2 * columns);
      matrix(wrapped, n) += filter[k];
    }
  }
  return matrix;
}

Eigen::MatrixXd beside(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right) {
  Eigen::MatrixXd both(left.rows(), left.cols() + right.cols());
  both << left, right;
  return both;
}

/// The scaling functions of 2^coarsest samples and the wavelets of 2^coarsest .. 2^finest samples,
/// in the basis of the scaling functions of 2^(finest + 1) samples.
Eigen::MatrixXd expansion(const FilterBank<double>& bank, int coarsest, int finest) {
  Eigen::MatrixXd functions = Eigen::MatrixXd::Identity(1 << coarsest, 1 << coarsest);
  for (int level = coarsest; level <= finest; ++level) {
    functions = beside(two_scale_matrix(bank.synthesis_low, 1 << level) * functions,
                       two_scale_matrix(bank.synthesis_high, 1 << level));
  }
  return functions;
}

Eigen::Index rank(const Eigen::MatrixXd& matrix) {
  return Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(matrix).rank();
}

Outcome evaluate() {
  const FilterBank<double> bank = find_filter_bank("db4");
  const int coarsest = 2;
  Table counts{
      "Functions on the right of (2.5) and the dimension they span; D8, |M_c| = 2",
      {"|M_f|", "dimension of V^{M_f}", "functions as printed", "rank as printed",
       "functions from M_f + 1", "rank from M_f + 1", "largest d^{M_f} of any f in V^{M_f}"},
      {}};
  bool is_slip = true;
  Eigen::Index functions = 0, spanned = 0;  // at the finest scale
  for (int finest = 3; finest <= 7; ++finest) {
    const Eigen::Index dimension = 1 << finest;
    const Eigen::MatrixXd printed = expansion(bank, coarsest, finest);
    const Eigen::MatrixXd corrected = expansion(bank, coarsest, finest - 1);
    const Eigen::MatrixXd finest_coefficients =
        two_scale_matrix(bank.analysis_high, 1 << finest).transpose() *
        two_scale_matrix(bank.synthesis_low, 1 << finest);
    is_slip = is_slip && rank(printed) != dimension && rank(corrected) == dimension;
    functions = printed.cols();
    spanned = dimension;
    counts.rows.push_back({std::to_string(finest), std::to_string(dimension),
                           std::to_string(printed.cols()), std::to_string(rank(printed)),
                           std::to_string(corrected.cols()), std::to_string(rank(corrected)),
                           fmt::format("{:.0e}", finest_coefficients.cwiseAbs().maxCoeff())});
  }
  return {
      is_slip ? ClaimVerdict::does_not_hold : ClaimVerdict::holds,
      {"the sum starts at m = M_f + 1; from M_f on, {} functions stand for a space of dimension {}",
       {counted("functions from M_f on", functions), counted("dimension of their space", spanned)}},
      "The wavelets of scale M_f span the orthogonal complement of V^{M_f} in the next finer "
      "space. "
      "They double the number of functions, and every f in V^{M_f} has the coefficient 0 with "
      "them.",
      {Paragraph{
           "With V^{m-1} = V^m + W^m, as printed below (2.4), V^{M_f} is V^{M_c} together with "
           "W^m for m = M_f + 1 .. M_c. The recursion (2.8) agrees: from c^{M_f} it yields "
           "d^{M_f + 1} first, and never d^{M_f}. The identity survives only because the "
           "superfluous terms vanish; as a count of coefficients it is wrong by a factor of "
           "two."},
       counts}};
}

const RegisterClaim registered({"erratum-2-5",
                                "The expansion (2.5) counts the finest scale once too often",
                                "Section 2.1, (2.5)",
                                "f(t) = Σ_n c_n^{M_f} φ_n^{M_f}(t) = Σ_n c_n^{M_c} φ_n^{M_c}(t) + "
                                "Σ_{m = M_f}^{M_c} Σ_n d_n^m ψ_n^m(t)",
                                evaluate});

}  // namespace

}  // namespace wavecurve::verification::erratum_2_5
