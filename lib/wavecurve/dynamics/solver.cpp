#include "wavecurve/dynamics/solver.hpp"

#include <stdexcept>

#include <fmt/ranges.h>

#include "wavecurve/dynamics/modal/decoupled.hpp"
#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/dynamics/stepping/coupled.hpp"
#include "wavecurve/dynamics/stepping/implicit.hpp"
#include "wavecurve/dynamics/stepping/massless.hpp"
#include "wavecurve/filters/bad_value.hpp"

namespace wavecurve::dynamics {

namespace {

using Problem = InitialValueProblem;

NamedSolver closed_form(const char* name, const char* summary,
                        Trajectory (*solve)(const Problem&, double)) {
  return {name, summary, Accuracy::closed_form, false, [solve](double tolerance) -> Solver {
            return [=](const Problem& problem) { return solve(problem, tolerance); };
          }};
}

NamedSolver coupled(const char* name, const char* summary, RungeKutta method,
                    Trajectory (*solve)(const Problem&, RungeKutta, double) = solve_coupled) {
  return {name, summary, Accuracy::tolerance, false, [=](double tolerance) -> Solver {
            return [=](const Problem& problem) { return solve(problem, method, tolerance); };
          }};
}

NamedSolver implicit(const char* name, const char* summary, Accuracy accuracy,
                     Trajectory (*solve)(const Problem&, double, LinearSolver),
                     LinearSolver method) {
  return {name, summary, accuracy, false, [=](double value) -> Solver {
            return [=](const Problem& problem) { return solve(problem, value, method); };
          }};
}

NamedSolver massless(const char* name, const char* summary, MasslessMethod method) {
  return {name, summary, Accuracy::step, true, [method](double step) -> Solver {
            return [=](const Problem& problem) { return solve_massless(problem, method, step); };
          }};
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
      implicit("implicit", "Newmark's average acceleration, conjugate gradients", Accuracy::step,
               solve_newmark, conjugate_gradients),
      implicit("implicit-ldlt", "as implicit, by sparse factorisation", Accuracy::step,
               solve_newmark, factorisation),
      implicit("implicit-rosenbrock", "Rosenbrock-W 3(2), conjugate gradients", Accuracy::tolerance,
               solve_rosenbrock, conjugate_gradients),
      implicit("implicit-rosenbrock-ldlt", "as implicit-rosenbrock, by sparse factorisation",
               Accuracy::tolerance, solve_rosenbrock, factorisation),
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
