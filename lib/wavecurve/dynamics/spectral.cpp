#include "wavecurve/dynamics/spectral.hpp"

#include "wavecurve/dynamics/modal_solution.hpp"

namespace wavecurve {

Trajectory solve_spectral(const InitialValueProblem& problem, double tolerance) {
  return solve_modes(problem, *fourier_basis(problem.system), tolerance);
}

}  // namespace wavecurve
