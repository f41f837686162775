#include "wavecurve/dynamics/modal/decoupled.hpp"

#include "wavecurve/dynamics/modal/detail/modal_solution.hpp"

namespace wavecurve::dynamics {

Trajectory solve_decoupled(const InitialValueProblem& problem, double tolerance) {
  return solve_modes(problem, *coefficient_basis(problem.system), tolerance);
}

Trajectory solve_block_decoupled(const InitialValueProblem& problem, double tolerance) {
  return solve_modes(problem, *band_fourier_basis(problem.system), tolerance);
}

}  // namespace wavecurve::dynamics
