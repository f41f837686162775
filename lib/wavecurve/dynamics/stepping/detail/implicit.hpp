#pragma once

#include "wavecurve/dynamics/initial_value_problem.hpp"
#include "wavecurve/dynamics/stepping/detail/shifted_solver.hpp"

namespace wavecurve::dynamics {

/// Newmark's method with average acceleration (beta = 1/4, gamma = 1/2) in equal steps of at most
/// step between two of the times: order 2, stable for any step, no numerical damping (the energy of
/// an undamped unforced curve is kept, phases drift). Each step solves one system with
/// M + h/2 C + h^2/4 K; forces that depend on the state are taken at the state predicted by the
/// last acceleration.
///
/// Throws as check(InitialValueProblem) does; std::invalid_argument unless step is above 0;
/// std::domain_error if the density is 0; SolutionStopped if an iteration or a force fails.
Trajectory solve_newmark(const InitialValueProblem& problem, double step, LinearSolver method);

/// The Rosenbrock-W method ROS34PW2 (J. Rang, L. Angermann, BIT 45 (2005)), order 3 with an
/// embedded one of order 2 for the control of the step: L-stable, so that stiff damping costs no
/// steps. Four systems with M + g h C + (g h)^2 K a step, g = 0.43...; the W property is what
/// allows K and C alone to stand for the derivative, however forces depend on time and state.
/// Tolerance and exceptions as in solve_coupled.
Trajectory solve_rosenbrock(const InitialValueProblem& problem, double tolerance,
                            LinearSolver method);

}  // namespace wavecurve::dynamics
