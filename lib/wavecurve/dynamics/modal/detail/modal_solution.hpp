#pragma once

#include "wavecurve/dynamics/initial_value_problem.hpp"
#include "wavecurve/dynamics/modal/detail/modal_basis.hpp"

namespace wavecurve::dynamics {

/// The solution of a problem whose system has fallen apart into the modes of a basis. Constant and
/// harmonic forces in closed form, without steps; with general forces by
/// integrate_exponentially. What spectral, block-decoupled and decoupled have in common.
///
/// Throws as check(InitialValueProblem) does; std::domain_error if neither mass nor damping acts on
/// a mode: without a density, C is singular then.
Trajectory solve_modes(const InitialValueProblem& problem, ModalBasis& basis, double tolerance);

}  // namespace wavecurve::dynamics
