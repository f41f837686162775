#pragma once

#include <functional>
#include <string>
#include <vector>

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::dynamics {

/// The one interface of all solvers.
using Solver = std::function<Trajectory(const InitialValueProblem&)>;

/// What the number that a solver is made with means.
enum class Accuracy {
  closed_form,  ///< the tolerance of general forces; all else is exact for the solver's model
  tolerance,    ///< of the estimated error of a step
  step,         ///< the step size
};

/// A solver by its name. make throws nothing; the solver it makes throws std::invalid_argument for
/// an accuracy that is not above 0.
struct NamedSolver {
  std::string name, summary;
  Accuracy accuracy;
  bool is_massless;  ///< needs density 0; the others, but those in closed form, need one above 0
  std::function<Solver(double accuracy)> make;
};

/// All of them: to add one, add a line there.
const std::vector<NamedSolver>& solvers();

/// Throws std::invalid_argument for an unknown name, naming those there are.
const NamedSolver& find_solver(const std::string& name);

}  // namespace wavecurve::dynamics
