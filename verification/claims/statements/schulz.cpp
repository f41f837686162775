// "X_n will converge to C^-1 quadratically" (section 3.3): orders from the residuals, and the step
// at which round-off ends it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/dynamics/schulz_inverse.hpp"
#include "wavecurve/elementary/logarithm.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/operators/spectrum.hpp"

#include "verification/study/named_shapes.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification::schulz_claim {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr Index samples = 64;
const std::vector<double> conditions = {2, 1e2, 1e4, 1e6, 1e8};
/// Never reached: the iteration goes on until round-off ends it.
constexpr double unreachable = std::numeric_limits<double>::min();

/// C = M + s_2 K of D8, whose smallest eigenvalue is 1, since K is singular.
Sparse damping_matrix(double condition) {
  const FilterBank<double> bank = find_filter_bank<double>("db4");
  const int levels = all_levels(samples);
  const double largest = extreme_eigenvalues(bank, samples, levels, 1).largest;
  return damping(bank, samples, levels, 1, (condition - 1) / largest);
}

double nearest(const certified::Ball& number) { return certified::round_to_double(number).value(); }

/// Not symmetric: singular values in geometric progression from 1 to the condition number, between
/// two reflections. Where round-off ends the iteration hangs on the last bits of the entries: these
/// are made from the doubles nearest to the cosines and powers, proved.
MatrixXd general_matrix(double condition) {
  const auto reflection = [](long frequency) -> MatrixXd {
    Eigen::VectorXd normal(samples);
    for (Index i = 0; i < samples; ++i) normal[i] = nearest(cos(certified::Ball(frequency * i)));
    normal.normalize();
    return MatrixXd::Identity(samples, samples) - 2 * normal * normal.transpose();
  };
  Eigen::VectorXd values(samples);
  const certified::Ball logarithm = log(certified::Ball::from_double(condition));
  for (Index i = 0; i < samples; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(samples - 1);
    values[i] = nearest(exp(logarithm * certified::Ball::from_double(share)));
  }
  return reflection(1) * values.asDiagonal() * reflection(2);
}

struct Run {
  std::vector<double> residuals;
  std::size_t begin = 0;        ///< the first step whose residual is below 1/2
  std::size_t end = 0;          ///< the last step before round-off
  std::optional<double> order;  ///< from the last three residuals up to there
};

/// Exactly, ||R_{n+1}|| = ||R_n^2|| <= ||R_n||^2. The first step that exceeds that by a tenth is
/// the work of round-off.
Run analysed(std::vector<double> residuals) {
  Run run{std::move(residuals), 0, 0, {}};
  const std::vector<double>& r = run.residuals;
  while (run.begin + 1 < r.size() && r[run.begin] >= 0.5) ++run.begin;
  run.end = run.begin;
  while (run.end + 1 < r.size() && r[run.end + 1] <= 1.1 * r[run.end] * r[run.end]) ++run.end;
  if (run.end >= 2 && r[run.end - 2] < 1) {
    run.order = logarithm(r[run.end] / r[run.end - 1]) / logarithm(r[run.end - 1] / r[run.end - 2]);
  }
  return run;
}

struct Case {
  std::string name;
  double condition;
  Run run;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const double condition : conditions) {
    const Sparse c = damping_matrix(condition);
    all.push_back({"C = M + s_2 K, dense", condition,
                   analysed(dynamics::schulz_inverse(MatrixXd(c), unreachable).residuals)});
    all.push_back({"C = M + s_2 K, sparse", condition,
                   analysed(dynamics::schulz_inverse(c, unreachable, 0).residuals)});
    all.push_back(
        {"general, dense", condition,
         analysed(dynamics::schulz_inverse(general_matrix(condition), unreachable).residuals)});
  }
  return all;
}

Table table_of(const std::vector<Case>& all) {
  Table table{fmt::format("Until round-off ends it; N = {}, Frobenius norms of I - X_n C", samples),
              {"matrix", "condition number", "first step below 1/2", "observed order",
               "last step before round-off", "residual there", "final residual"},
              {}};
  for (const auto& [name, condition, run] : all) {
    table.rows.push_back({name, fmt::format("{:.0e}", condition), std::to_string(run.begin),
                          run.order ? fmt::format("{:.2f}", *run.order) : "too few steps",
                          std::to_string(run.end), fmt::format("{:.0e}", run.residuals[run.end]),
                          fmt::format("{:.0e}", run.residuals.back())});
  }
  return table;
}

Chart residual_chart(const std::vector<Case>& all) {
  Chart chart;
  chart.id = "schulz-residuals";
  chart.data = {"Residual by step; C = M + s_2 K of D8, sparse", {"step"}, {}};
  std::vector<const Run*> runs;
  std::size_t steps = 0;
  for (const Case& one : all) {
    if (!one.name.ends_with("sparse")) continue;
    chart.data.columns.push_back(fmt::format("condition number {:.0e}", one.condition));
    runs.push_back(&one.run);
    steps = std::max(steps, one.run.residuals.size());
  }
  for (std::size_t i = 0; i < steps; ++i) {
    std::vector<std::string> row{std::to_string(i)};
    for (const Run* run : runs) {
      row.push_back(i < run->residuals.size() ? fmt::format("{:.1e}", run->residuals[i]) : "");
    }
    chart.data.rows.push_back(row);
  }
  chart.script = fmt::format(
      "set xlabel \"step\"\nset ylabel \"residual\"\nset logscale y\nset format y \"10^{{%T}}\"\n"
      "plot for [i=2:{}] data using 1:i with linespoints\n",
      runs.size() + 1);
  return chart;
}

Outcome evaluate() {
  const std::vector<Case> all = cases();
  // Nearer to 2 than to 1: the norm of all eigenvalues of R comes to obey the largest one only as
  // the residual falls, so that the order tends to 2 from below.
  bool all_quadratic = true;
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;
  std::size_t steps = 0;
  double final_residual = 0;
  for (const auto& [name, condition, run] : all) {
    all_quadratic = all_quadratic && run.order && *run.order > 1.5;
    if (run.order) {
      lowest = std::min(lowest, *run.order);
      highest = std::max(highest, *run.order);
    }
    if (condition < conditions.back()) continue;
    steps = std::max(steps, run.end);
    final_residual = std::max(final_residual, run.residuals.back());
  }
  Outcome outcome;
  outcome.verdict = all_quadratic ? ClaimVerdict::holds : ClaimVerdict::undecided;
  outcome.finding = {
      "orders {} to {}; at condition number {} round-off ends it after step {} at a residual of {}",
      {to_decimals("lowest order", lowest, 2), to_decimals("highest order", highest, 2),
       to_digits("largest condition number", conditions.back(), 1),
       counted("steps at this condition number", static_cast<long long>(steps)),
       to_digits("last residual at this condition number", final_residual, 1)}};
  outcome.summary =
      "The residual is squared in every step, for dense and sparse matrices alike. But the "
      "quadratic phase only begins after about 2 log2(condition number) steps. Round-off ends it, "
      "for general matrices at a residual that grows with the condition number.";
  outcome.evidence = {residual_chart(all), table_of(all)};
  return outcome;
}

const RegisterClaim registered({"schulz", "Schulz' iteration converges quadratically",
                                "Section 3.3",
                                "X_0 = C^T / ||C^T C||; X_n will converge to C^-1 quadratically",
                                evaluate});

}  // namespace

}  // namespace wavecurve::verification::schulz_claim
