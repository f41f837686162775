#pragma once

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::dynamics::plain {

/// The plain twin of solve_spectral: the exponential of the dense first-order system (3.15), as it
/// should read, in the multiscale basis with M, C, K assembled, constant and harmonic forces as
/// further unknowns. O(samples^3) for each time. Scalar double or long double. Throws as
/// solve_spectral does.
template <class Scalar>
Trajectory solve_matrix_exponential(const InitialValueProblem& problem);

}  // namespace wavecurve::dynamics::plain
