#pragma once

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::dynamics {

/// Methods for the massless equation C q' + K q = Q, fixed steps. The exact solution is
/// solve_spectral's.
enum class MasslessMethod {
  schulz_euler,    ///< explicit Euler, C^-1 by Schulz' iteration: the publication's, section 3.3
  explicit_euler,  ///< the same with a sparse factorisation of C
  backward_euler,  ///< order 1, stable for any step
  crank_nicolson,  ///< order 2, stable for any step
};

/// In equal steps of at most step between two of the times. The publication's C = s_2 K is
/// singular; the damping density makes it regular. Forces that depend on the state are taken at the
/// last state (crank_nicolson: also at the one that follows from it), their velocities are those of
/// the last step.
///
/// Throws as check(InitialValueProblem) does; std::invalid_argument unless step is above 0;
/// std::domain_error if the density is not 0, if C is singular, and if an explicit step exceeds the
/// stability_bound, unless is_forced; SolutionStopped if a force fails.
Trajectory solve_massless(const InitialValueProblem& problem, MasslessMethod method, double step,
                          bool is_forced = false);

/// 2 / (the largest eigenvalue of C^-1 K): explicit Euler grows beyond it. Infinite for K = 0.
double stability_bound(const LagrangeSystem& system);

}  // namespace wavecurve::dynamics
