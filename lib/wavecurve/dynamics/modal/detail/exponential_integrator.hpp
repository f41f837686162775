#pragma once

#include "wavecurve/dynamics/initial_value_problem.hpp"
#include "wavecurve/dynamics/modal/detail/modal_basis.hpp"

namespace wavecurve::dynamics {

/// Duhamel's integral, q(t + h) = (free motion) + int_0^h response(h - s) Q(t + s) ds, mode by
/// mode: the linear part is exact however stiff, and the force is interpolated in time, its values
/// at the stages from Krogstad's exponential Runge-Kutta scheme of order 4 (S. Krogstad, J. Comput.
/// Phys. 203 (2005), ETDRK4-B), which forces that depend on time alone see as Simpson's rule. The
/// functions phi_k of the scheme are the responses to powers of time (ramp_response).
///
/// Each step is done twice, once as two halves: the halves are kept, and a fifteenth of the
/// difference is the estimate of their error. It is at most tolerance, relative to the largest
/// norms so far of displacement and h times velocity, and of velocity and h times acceleration;
/// steps are powers of two of the distance between times. A harmonic force costs steps here.
/// Without density, general forces see the velocity of the last step.
///
/// Throws std::invalid_argument unless tolerance is above 0; SolutionStopped if a general force
/// fails or the step falls below 2^-40 of that distance.
Trajectory integrate_exponentially(const InitialValueProblem& problem, ModalBasis& basis,
                                   double tolerance);

}  // namespace wavecurve::dynamics
