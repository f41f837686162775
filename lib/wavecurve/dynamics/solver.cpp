#include "wavecurve/dynamics/solver.hpp"

#include <stdexcept>

#include <fmt/ranges.h>

#include "wavecurve/dynamics/modal/decoupled.hpp"
#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/dynamics/stepping/coupled.hpp"
#include "wavecurve/dynamics/stepping/detail/implicit.hpp"
#include "wavecurve/dynamics/stepping/massless.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::dynamics {

namespace {

using Problem = InitialValueProblem;

constexpr double default_tolerance = 1e-9;

/// The number that a solver of that kind takes.
double number_of(const char* name, AccuracyKind kind, const Accuracy& accuracy) {
  const bool is_step = kind == AccuracyKind::step;
  const std::optional<double>& given = is_step ? accuracy.step : accuracy.tolerance;
  if (!given && kind != AccuracyKind::closed_form) {
    throw std::invalid_argument(fmt::format("solver {} needs a {}, but none is given", name,
                                            is_step ? "step" : "tolerance"));
  }
  return given.value_or(default_tolerance);
}

/// A solver from a function of a problem and of the number that its kind takes.
template <class Solve>
NamedSolver named(const char* name, const char* summary, AccuracyKind kind, bool is_massless,
                  Solve solve) {
  return {name, summary, kind, is_massless, [=](const Accuracy& accuracy) -> Solver {
            const double number = number_of(name, kind, accuracy);
            return [=](const Problem& problem) { return solve(problem, number); };
          }};
}

NamedSolver closed_form(const char* name, const char* summary,
                        Trajectory (*solve)(const Problem&, double)) {
  return named(name, summary, AccuracyKind::closed_form, false, solve);
}

NamedSolver coupled(const char* name, const char* summary, RungeKutta method,
                    Trajectory (*solve)(const Problem&, RungeKutta, double) = solve_coupled) {
  return named(
      name, summary, AccuracyKind::tolerance, false,
      [=](const Problem& problem, double tolerance) { return solve(problem, method, tolerance); });
}

NamedSolver implicit(const char* name, const char* summary, AccuracyKind kind,
                     Trajectory (*solve)(const Problem&, double, LinearSolver),
                     LinearSolver method) {
  return named(name, summary, kind, false, [=](const Problem& problem, double number) {
    return solve(problem, number, method);
  });
}

NamedSolver massless(const char* name, const char* summary, MasslessMethod method) {
  return named(name, summary, AccuracyKind::step, true, [=](const Problem& problem, double step) {
    return solve_massless(problem, method, step);
  });
}

std::vector<NamedSolver> all() {
  using enum RungeKutta;
  using enum LinearSolver;
  return {
      closed_form("spectral", "exact, by the Fourier transform", solve_spectral),
      closed_form("decoupled", "off-diagonal entries dropped, closed form", solve_decoupled),
      closed_form("block-decoupled", "blocks between bands dropped, closed form",
                  solve_block_decoupled),
      coupled("coupled", "Runge-Kutta of order 4 with step doubling", step_doubling),
      coupled("coupled-cash-karp", "Cash-Karp 5(4)", cash_karp),
      coupled("coupled-dormand-prince", "Dormand-Prince 5(4), dense output", dormand_prince),
      coupled("coupled-dense", "as coupled, with dense matrices", step_doubling,
              plain::solve_coupled),
      implicit("implicit", "Newmark's average acceleration, conjugate gradients",
               AccuracyKind::step, solve_newmark, conjugate_gradients),
      implicit("implicit-ldlt", "as implicit, by sparse factorisation", AccuracyKind::step,
               solve_newmark, factorisation),
      implicit("implicit-rosenbrock", "Rosenbrock-W 3(2), conjugate gradients",
               AccuracyKind::tolerance, solve_rosenbrock, conjugate_gradients),
      implicit("implicit-rosenbrock-ldlt", "as implicit-rosenbrock, by sparse factorisation",
               AccuracyKind::tolerance, solve_rosenbrock, factorisation),
      massless("massless", "explicit Euler, Schulz' inverse", MasslessMethod::schulz_euler),
      massless("massless-euler", "explicit Euler, sparse factorisation",
               MasslessMethod::explicit_euler),
      massless("massless-backward-euler", "backward Euler", MasslessMethod::backward_euler),
      massless("massless-crank-nicolson", "Crank-Nicolson", MasslessMethod::crank_nicolson),
  };
}

}  // namespace

const std::vector<NamedSolver>& solvers() {
  static const std::vector<NamedSolver> list = all();
  return list;
}

const NamedSolver& find_solver(const std::string& name) {
  for (const NamedSolver& solver : solvers()) {
    if (solver.name == name) return solver;
  }
  throw std::invalid_argument(unknown_name("solver", name, solvers(), &NamedSolver::name));
}

}  // namespace wavecurve::dynamics
