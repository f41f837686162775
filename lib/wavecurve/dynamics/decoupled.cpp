#include "wavecurve/dynamics/decoupled.hpp"

#include "wavecurve/dynamics/modal_solution.hpp"

namespace wavecurve {

Trajectory solve_decoupled(const InitialValueProblem& problem, double tolerance) {
  return solve_modes(problem, *coefficient_basis(problem.system), tolerance);
}

Trajectory solve_block_decoupled(const InitialValueProblem& problem, double tolerance) {
  return solve_modes(problem, *band_fourier_basis(problem.system), tolerance);
}

}  // namespace wavecurve
