#include "wavecurve/dynamics/modal/spectral.hpp"

#include "wavecurve/dynamics/modal/detail/modal_solution.hpp"

namespace wavecurve::dynamics {

Trajectory solve_spectral(const InitialValueProblem& problem, double tolerance) {
  return solve_modes(problem, *fourier_basis(problem.system), tolerance);
}

}  // namespace wavecurve::dynamics
