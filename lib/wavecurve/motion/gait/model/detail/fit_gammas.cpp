#include "wavecurve/motion/gait/model/detail/fit_gammas.hpp"

#include <cmath>
#include <limits>

#include "wavecurve/elementary/root.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Eigen::VectorXi;

/// Sums over coefficients by group.
VectorXd grouped(const VectorXd& values, const VectorXi& group, Index groups) {
  VectorXd sums = VectorXd::Zero(groups);
  for (Index i = 0; i < values.size(); ++i) sums[group[i]] += values[i];
  return sums;
}

VectorXd grouped_square(const Eigen::RowVectorXd& values, const VectorXi& group, Index groups) {
  return grouped(values.transpose().cwiseAbs2(), group, groups);
}

/// What the errors of a run add to the variance of gamma's numerator and to the residuals, for
/// s = 1: of one coefficient with q_1 - q_2 = 1.
struct Spread {
  double numerator = 0, residuals = 0;
};

Spread spread(const PhaseRun& run, const VectorXd& w, double gamma) {
  const VectorXd f = 1 - run.tau.array() + gamma * w.array();
  const VectorXd rest = 1 - f.array();
  return {w.squaredNorm() + whole_power(w.dot(f), 2) + whole_power(w.dot(rest), 2),
          static_cast<double>(f.size()) + f.squaredNorm() + rest.squaredNorm()};
}

VectorXd bend(const PhaseRun& run) { return run.tau.cwiseAbs2() - run.tau; }

}  // namespace

VectorXi each_coefficient(Index coefficients) {
  return VectorXi::LinSpaced(coefficients, 0, static_cast<int>(coefficients) - 1);
}

VectorXi all_coefficients(Index coefficients) { return VectorXi::Zero(coefficients); }

Gammas fit_gammas(const PhaseData& data, const VectorXi& group, double least_movement) {
  const Index groups = group.maxCoeff() + 1;
  VectorXd numerator = VectorXd::Zero(groups), denominator = numerator, movement = numerator;
  VectorXd squares = numerator;  // of off_line
  const VectorXd members = grouped(VectorXd::Ones(group.size()), group, groups);
  for (const PhaseRun& run : data.runs) {
    const VectorXd w = bend(run);
    const Eigen::RowVectorXd difference = run.from - run.to;
    const Eigen::MatrixXd e = off_line(run);
    const VectorXd product = (w.transpose() * e).cwiseProduct(difference).transpose();
    numerator += grouped(product, group, groups);
    const VectorXd moved = grouped_square(difference, group, groups);
    denominator += moved * w.squaredNorm();
    movement += moved;
    squares += grouped(e.colwise().squaredNorm().transpose(), group, groups);
  }
  movement = (movement.array() / members.array() / static_cast<double>(data.runs.size())).sqrt();

  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Gammas result{VectorXd::Constant(groups, none), VectorXd::Constant(groups, none)};
  for (Index g = 0; g < groups; ++g) {
    if (!(movement[g] >= least_movement) || denominator[g] == 0) continue;
    result.gamma[g] = numerator[g] / denominator[g];
  }
  VectorXd variance = VectorXd::Zero(groups), expected = VectorXd::Zero(groups);
  for (const PhaseRun& run : data.runs) {
    const VectorXd w = bend(run);
    const VectorXd moved = grouped_square(run.from - run.to, group, groups);
    for (Index g = 0; g < groups; ++g) {
      const Spread of_run = spread(run, w, result.gamma[g]);
      variance[g] += moved[g] * of_run.numerator;
      expected[g] += members[g] * of_run.residuals;
    }
  }
  for (Index g = 0; g < groups; ++g) {
    // In exact arithmetic neither is negative.
    const double residuals = std::max(0.0, squares[g] - result.gamma[g] * numerator[g]);
    const double freedom = expected[g] - variance[g] / denominator[g];
    const double s = std::sqrt(residuals / freedom);
    result.standard_error[g] = s * std::sqrt(variance[g]) / denominator[g];
  }
  return result;
}

}  // namespace wavecurve::gait
