#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::dynamics {

/// The one interface of all solvers.
using Solver = std::function<Trajectory(const InitialValueProblem&)>;

/// How exact a solver shall be, by the name of the number: make({.tolerance = 1e-8}) or
/// make({.step = 0.01}). A solver takes the one of the two that its kind has (see AccuracyKind).
struct Accuracy {
  std::optional<double> tolerance = std::nullopt;  ///< of the estimated error of a step, relative
  std::optional<double> step = std::nullopt;       ///< the step size, a time
};

/// Which of the two a solver takes.
enum class AccuracyKind {
  closed_form,  ///< a tolerance, of general forces, 1e-9 if not given; all else is exact for the
                ///< solver's model
  tolerance,    ///< a tolerance
  step,         ///< a step
};

/// A solver by its name.
struct NamedSolver {
  std::string name, summary;
  AccuracyKind accuracy;
  bool is_massless;  ///< needs density 0; the others, but those in closed form, need one above 0
  /// The solver at an accuracy. What steps through time throws std::domain_error (SolutionStopped) as
  /// soon as it foresees more than some ten seconds of work (detail/work_bound.hpp). Throws std::invalid_argument unless the number that the solver
  /// takes is given; the solver that it makes does so unless the number is above 0.
  std::function<Solver(const Accuracy& accuracy)> make;
};

/// All of them: to add one, add a line there.
const std::vector<NamedSolver>& solvers();

/// Throws std::invalid_argument for an unknown name, naming those there are.
const NamedSolver& find_solver(const std::string& name);

}  // namespace wavecurve::dynamics
