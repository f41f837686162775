#include "benchmarks/kernels/accuracy.hpp"

#include <algorithm>
#include <cmath>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/dynamics/schulz_inverse.hpp"
#include "wavecurve/dynamics/solver.hpp"
#include "wavecurve/dynamics/stepping/detail/shifted_solver.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/connection_coefficients.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/operators/multiscale_operator.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

#include "benchmarks/kernels/kernel.hpp"
#include "benchmarks/kernels/test_problem.hpp"

namespace wavecurve::tracking {

namespace {

constexpr double unit = 0x1p-52;
constexpr long bits_of_50_digits = 170;

/// The largest |inverse(forward(x)) - x| / |x| of several signals, in units of 2^-52 a level.
double round_trip(const std::string& filter) {
  constexpr Eigen::Index samples = 4096;
  const int levels = all_levels(samples);
  const PeriodicTransform<double> transform(find_filter_bank<double>(filter), samples, levels);
  const Eigen::MatrixXd x = Eigen::MatrixXd::Random(samples, 8);
  Eigen::MatrixXd y = x;
  Eigen::VectorXd workspace(transform.workspace_size(x.cols()));
  transform.forward(y, y, workspace);
  transform.inverse(y, y, workspace);
  const double worst = ((y - x).colwise().norm().array() / x.colwise().norm().array()).maxCoeff();
  return worst / unit / levels;
}

/// The product without a matrix against that with one, in units of 2^-52 of the largest entry.
double product_error() {
  constexpr Eigen::Index samples = 1024;
  const auto bank = find_filter_bank<double>("db4");
  MultiscaleOperator k(bank, samples, all_levels(samples));
  const Eigen::VectorXd x = Eigen::VectorXd::Random(samples);
  const Eigen::VectorXd exact = stiffness(bank, samples, all_levels(samples)) * x;
  Eigen::VectorXd y(samples);
  k.apply(x, y);
  return (y - exact).lpNorm<Eigen::Infinity>() / exact.lpNorm<Eigen::Infinity>() / unit;
}

/// mu in double against the enclosures, in units of 2^-52 of the largest.
double coefficients_error(const std::string& filter) {
  const auto computed = connection_coefficients(find_filter_bank<double>(filter));
  const auto proved = certified::connection_coefficients(certified::find_filter(filter), 1, 1, 64);
  double worst = 0;
  for (int l = 0; l <= proved.mu.last_index(); ++l) {
    worst = std::max(worst, std::abs(computed.mu[l] - proved.mu[l].to_double()));
  }
  return worst / proved.mu[0].to_double() / unit;
}

/// The fewest digits that the enclosures of mu prove, of 50 asked for.
double digits_proved(const std::string& filter) {
  const auto c =
      certified::connection_coefficients(certified::find_filter(filter), 1, 1, bits_of_50_digits);
  // Where a coefficient is an exact number there is no bound to its digits.
  double least = 100;
  for (int l = 0; l <= c.mu.last_index(); ++l) {
    if (c.mu[l].is_exact()) continue;
    const double bits = static_cast<double>(c.mu[l].accuracy_bits());
    least = std::min(least, bits * std::log10(2.0));
  }
  return least;
}

void add_solver(std::vector<Accuracy>& list, const std::string& name, double accuracy,
                const dynamics::Material& material) {
  const dynamics::InitialValueProblem problem = ellipse(64, 2, material);
  const dynamics::Trajectory exact = dynamics::solve_spectral(problem);
  const dynamics::Trajectory solution =
      dynamics::find_solver(name).make({.tolerance = accuracy, .step = accuracy})(problem);
  const double scale = exact.displacement.front().norm();
  list.push_back({"solver_" + name, "error",
                  (solution.displacement.back() - exact.displacement.back()).norm() / scale});
  list.push_back({"solver_" + name + "_evaluations", "iterations",
                  static_cast<double>(solution.cost.evaluations)});
}

void add_conjugate_gradients(std::vector<Accuracy>& list) {
  constexpr Eigen::Index samples = 1024;
  const dynamics::LagrangeSystem system(find_filter_bank<double>("db4"), samples,
                                        all_levels(samples), {});
  dynamics::SystemOperator a(system, 1, 1);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(samples, -1, 1);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(samples);
  list.push_back({"conjugate_gradients", "iterations",
                  static_cast<double>(dynamics::conjugate_gradients(a, b, x, 1e-8, true))});
}

void add_schulz(std::vector<Accuracy>& list) {
  const Eigen::MatrixXd c = damping(find_filter_bank<double>("db4"), 64, 6, 1, 1e-4);
  const auto result = dynamics::schulz_inverse(c, 1e-9);
  list.push_back({"schulz_inverse", "iterations", static_cast<double>(result.residuals.size())});
  list.push_back({"schulz_inverse_residual", "error", result.residuals.back()});
}

}  // namespace

std::vector<Accuracy> measure_accuracy() {
  std::vector<Accuracy> list;
  for (const char* filter : {"db4", "coif2", "sym8", "cdf9.7", "bspline4.4"}) {
    list.push_back({std::string("round_trip_") + filter, "error", round_trip(filter)});
  }
  list.push_back({"operator_product", "error", product_error()});
  for (const char* filter : {"db4", "coif2"}) {
    list.push_back({std::string("coefficients_") + filter, "error", coefficients_error(filter)});
    list.push_back({std::string("digits_") + filter, "digits", digits_proved(filter)});
  }
  add_solver(list, "coupled", 1e-6, {});
  add_solver(list, "implicit", 1e-3, {.mass_damping = 0.5, .stiffness_damping = 1e-3});
  add_conjugate_gradients(list);
  add_schulz(list);
  return list;
}

}  // namespace wavecurve::tracking
