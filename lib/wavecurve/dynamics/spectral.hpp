#pragma once

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve {

/// The exact solution. On the finest level all matrices are circulants, so the discrete Fourier
/// transform decouples the coupled system exactly, for every bank and Rayleigh damping: one
/// oscillator a frequency, each in closed form (oscillator.hpp). O(samples log samples) for any
/// time, without steps. Constant and harmonic forces are part of the closed form.
///
/// The error is rounding alone: relative to the largest part of the state that the energy allows,
/// a few units times log2(samples) + omega t of the frequency. For equally spaced times
/// propagators are products of two tabulated ones, a few more units.
///
/// Throws as check(InitialValueProblem) does; std::domain_error if the density is zero, or for a
/// general force.
Trajectory solve_spectral(const InitialValueProblem& problem);

}  // namespace wavecurve
