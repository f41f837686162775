#pragma once

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::dynamics {

/// Explicit Runge-Kutta methods with a controlled step size, of Boost.Odeint.
enum class RungeKutta {
  step_doubling,   ///< the classic one of order 4: one step against its two halves
  cash_karp,       ///< 5(4)
  dormand_prince,  ///< 5(4), with dense output: steps are not cut at the times wanted
};

/// The coupled system in first-order form (3.15), where the print has 1/rho before the identity
/// block by mistake:
///   d/dt (q, q') = (q', M^-1 (Q - C q' - K q)).
/// step_doubling is "the fourth-order Runge-Kutta formula and an adaptive stepsize controller" of
/// the publication's section 3.3, as it is usually written: the difference of the two results is
/// the error estimate, and a fifteenth of it improves the finer one (order 5).
///
/// The estimated error of a step is at most tolerance, of the displacement relative to |q| + h
/// |q'|, of the velocity relative to |q'| + h |q''|, L2 norms of the coefficients of all
/// coordinates. An evaluation costs O(samples) for orthonormal banks, see ReducedStiffness; steps
/// are bounded by stability, about 3 / (largest frequency), whatever the tolerance.
///
/// Throws as check(InitialValueProblem) does; std::invalid_argument unless tolerance is above 0;
/// std::domain_error if the density is 0; SolutionStopped if the step size vanishes or a force
/// fails.
Trajectory solve_coupled(const InitialValueProblem& problem, RungeKutta method, double tolerance);

}  // namespace wavecurve::dynamics

namespace wavecurve::dynamics::plain {

/// The plain twin, with dense matrices M^-1 C and M^-1 K: O(samples^2) an evaluation.
Trajectory solve_coupled(const InitialValueProblem& problem, RungeKutta method, double tolerance);

}  // namespace wavecurve::dynamics::plain
