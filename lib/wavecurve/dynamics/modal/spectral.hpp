#pragma once

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::dynamics {

/// The exact solution. On the finest level all matrices are circulants, so the discrete Fourier
/// transform decouples the coupled system exactly, for every bank and Rayleigh damping: one
/// oscillator a frequency, each in closed form (oscillator.hpp). O(samples log samples) for any
/// time, without steps. Constant and harmonic forces are part of the closed form, and density 0
/// (the massless equation C q' + K q = Q) is one more case of it. With general forces there are
/// steps, of an exponential integrator, whose tolerance is the one
/// given here.
///
/// The error is rounding alone: relative to the largest part of the state that the energy allows,
/// a few units times log2(samples) + omega t of the frequency. For equally spaced times
/// propagators are powers of two of them: a few units more times the root of the number of times.
///
/// Throws as check(InitialValueProblem) does; std::domain_error if the density is zero and C
/// singular; with general forces as integrate_exponentially does.
Trajectory solve_spectral(const InitialValueProblem& problem, double tolerance = 1e-9);

}  // namespace wavecurve::dynamics
