#include "solver_study.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>
#include <stdexcept>
#include <utility>

#include "wavecurve/dynamics/spectral.hpp"

#include "motion_error.hpp"
#include "named_shapes.hpp"

namespace wavecurve::verification {

namespace {

constexpr Eigen::Index instants = 41;
/// Of a closed form: forces, which alone would need it, are absent.
constexpr double unused_tolerance = 1e-9;
/// A solve is repeated within these bounds: the least time is the least disturbed.
constexpr int most_runs = 5;
constexpr double most_seconds = 0.2;

struct Timed {
  Trajectory trajectory;
  double seconds;
};

Timed timed(const Solver& solver, const InitialValueProblem& problem) {
  using Clock = std::chrono::steady_clock;
  Timed result{{}, std::numeric_limits<double>::infinity()};
  double all = 0;
  for (int run = 0; run < most_runs && (run == 0 || all < most_seconds); ++run) {
    const auto start = Clock::now();
    result.trajectory = solver(problem);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    result.seconds = std::min(result.seconds, seconds);
    all += seconds;
  }
  return result;
}

StudyPoint solved(const NamedSolver& solver, const std::optional<double>& tolerance,
                  const InitialValueProblem& problem, const Trajectory& exact) {
  StudyPoint point{solver.name, tolerance, {}, {}, 0, {}};
  try {
    const Timed run = timed(solver.make(tolerance.value_or(unused_tolerance)), problem);
    const Eigen::VectorXd displacement = displacement_errors(problem, run.trajectory, exact);
    const Eigen::VectorXd energy = energy_errors(problem, run.trajectory, exact);
    point.errors = {displacement.maxCoeff(), displacement[displacement.size() - 1],
                    energy.maxCoeff()};
    point.cost = run.trajectory.cost;
    point.seconds = run.seconds;
  } catch (const std::exception& error) {
    point.failure = error.what();
  }
  return point;
}

}  // namespace

std::vector<std::optional<double>> sweep(const NamedSolver& solver) {
  switch (solver.accuracy) {
    case Accuracy::tolerance:
      return {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
    case Accuracy::step:
      return {1.0 / 64, 1.0 / 128, 1.0 / 256, 1.0 / 512, 1.0 / 1024, 1.0 / 2048};
    case Accuracy::closed_form:
      break;
  }
  return {std::nullopt};
}

std::vector<StudyPoint> run_study(const Study& study,
                                  const std::function<void(std::size_t, std::size_t)>& progress) {
  std::vector<std::pair<const NamedSolver*, std::optional<double>>> plan;
  for (const std::string& name : study.solvers) {
    const NamedSolver& solver = find_solver(name);
    for (const auto& tolerance : sweep(solver)) plan.emplace_back(&solver, tolerance);
  }
  const InitialValueProblem problem =
      released(study.system, study.shape, Eigen::VectorXd::LinSpaced(instants, 0, 1));
  // What the transform's rounding leaves of a circle is no deformation.
  if (problem.displacement.norm() <= 1e-12 * problem.rest.norm()) {
    throw std::invalid_argument("shape is the unit circle, but must differ from the rest shape");
  }
  const Trajectory exact = solve_spectral(problem);
  std::vector<StudyPoint> points;
  for (const auto& [solver, tolerance] : plan) {
    points.push_back(solved(*solver, tolerance, problem, exact));
    progress(points.size(), plan.size());
  }
  return points;
}

}  // namespace wavecurve::verification
