// Section 3.3 sets rho = 0 and inverts C by Schulz' iteration. With M = rho I the mass part of
// C = s_1 M + s_2 K goes too, and s_2 K annihilates the constants.
#include <string>

#include <Eigen/Dense>
#include <fmt/core.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

#include "verification/suite/claim.hpp"

namespace wavecurve::verification::erratum_massless_damping {

namespace {

using Eigen::MatrixXd;

constexpr double s1 = 1.0, s2 = 0.01;

MatrixXd damping(const MatrixXd& stiffness, double rho) {
  return s1 * rho * MatrixXd::Identity(stiffness.rows(), stiffness.cols()) + s2 * stiffness;
}

Eigen::Index rank(const MatrixXd& matrix) {
  return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(matrix).rank();
}

Table singular_values() {
  Table table{"Rank and singular values of C = s_1 ρ I + s_2 K; D8, s_1 = 1, s_2 = 0.01",
              {"N", "ρ", "rank", "smallest / largest singular value"},
              {}};
  for (const int samples : {16, 32, 64}) {
    const MatrixXd stiffness = wavecurve::stiffness(find_filter_bank("db4"), samples, 0);
    for (const double rho : {1.0, 0.0}) {
      const MatrixXd matrix = damping(stiffness, rho);
      const Eigen::VectorXd sizes = Eigen::JacobiSVD<MatrixXd>(matrix).singularValues();
      table.rows.push_back({std::to_string(samples), fmt::format("{}", rho),
                            std::to_string(rank(matrix)),
                            fmt::format("{:.0e}", sizes(samples - 1) / sizes(0))});
    }
  }
  return table;
}

/// X_0 = C^T / |C^T C|, X <- 2 X - X C X. The norm is that of the largest column sum.
Chart schulz_chart(const MatrixXd& matrix) {
  const auto n = matrix.rows();
  const MatrixXd pseudo_inverse =
      Eigen::CompleteOrthogonalDecomposition<MatrixXd>(matrix).pseudoInverse();
  MatrixXd x =
      matrix.transpose() / (matrix.transpose() * matrix).cwiseAbs().colwise().sum().maxCoeff();
  Chart chart;
  chart.id = "erratum-massless-damping-schulz";
  chart.data = {"Schulz' iteration on C = s_2 K; D8, N = 16, Frobenius norms",
                {"iteration", "distance to the pseudo-inverse, relative", "|C X - I|"},
                {}};
  for (int iteration = 0; iteration <= 40; ++iteration) {
    chart.data.rows.push_back(
        {std::to_string(iteration),
         fmt::format("{:.2e}", (x - pseudo_inverse).norm() / pseudo_inverse.norm()),
         fmt::format("{:.6f}", (matrix * x - MatrixXd::Identity(n, n)).norm())});
    x = 2 * x - x * matrix * x;
  }
  chart.script =
      "set logscale y\nset format y \"%.0e\"\nset xlabel \"iteration\"\n"
      "plot data using 1:2 with linespoints, data using 1:3 with linespoints\n";
  return chart;
}

Outcome evaluate() {
  const int samples = 64;
  const MatrixXd stiffness = wavecurve::stiffness(find_filter_bank("db4"), samples, 0);
  const MatrixXd massless = damping(stiffness, 0);
  const Eigen::Index found = rank(massless);
  const bool is_singular = found < samples && rank(damping(stiffness, 1)) == samples;
  return {
      is_singular ? ClaimVerdict::does_not_hold : ClaimVerdict::holds,
      {"C = s_2 K has rank {} of {}: no inverse; Schulz' iteration tends to the pseudo-inverse",
       {counted("rank of C without mass", found), counted("N", samples)}},
      "With ρ = 0 the mass damping s_1 M vanishes along with M, and the constants are in the "
      "null "
      "space of what is left. For pure mass damping, s_2 = 0, nothing at all is left.",
      {Paragraph{
           "The step q + Δt C^-1 (Q_e - K q) of the print does not exist. With the pseudo-inverse "
           "in place of the inverse it moves everything but the mean, which it leaves where it "
           "was; a force with a mean other than zero is not balanced at all."},
       singular_values(),
       Paragraph{
           "|C X - I| ends at 1, since C X becomes the projection onto the complement of the "
           "constants. Past its best, the distance grows again: on the null space the step is X <- "
           "2 X, so that rounding errors there double each time. The iteration must be stopped."},
       schulz_chart(damping(wavecurve::stiffness(find_filter_bank("db4"), 16, 0), 0))}};
}

const RegisterClaim registered(
    {"erratum-massless-damping", "Without mass the damping matrix has no inverse", "Section 3.3",
     "setting the mass density ρ to zero to obtain C q̇ + K q = Q_e "
     "... q^{(t + Δt)} = q^{(t)} + Δt C^-1 "
     "(Q_e^{(t)} - K q^{(t)}) ... X_n will converge to C^-1 quadratically",
     evaluate});

}  // namespace

}  // namespace wavecurve::verification::erratum_massless_damping
