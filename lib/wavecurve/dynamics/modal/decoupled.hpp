#pragma once

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::dynamics {

/// The publication's simplification (section 3.3): the off-diagonal entries of M, C and K are
/// dropped, and each coefficient is an oscillator of its own, (3.16), in closed form. M is diagonal
/// for orthonormal banks only; of a biorthogonal one its off-diagonals are dropped as well, also
/// those of G in Q = G f. How far the result is from the coupled motion: solve_spectral tells.
///
/// Forces and errors as in solve_spectral: constants and harmonics in closed form, general forces
/// by Duhamel's integral, to the tolerance. Throws as solve_spectral does.
Trajectory solve_decoupled(const InitialValueProblem& problem, double tolerance = 1e-9);

/// The same with the diagonal blocks kept, those within one band: circulants, which the Fourier
/// transform of the band decouples exactly. What is dropped couples different bands.
Trajectory solve_block_decoupled(const InitialValueProblem& problem, double tolerance = 1e-9);

}  // namespace wavecurve::dynamics
