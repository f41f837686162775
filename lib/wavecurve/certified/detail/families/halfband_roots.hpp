#pragma once

#include <vector>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/detail/polynomial.hpp"

namespace wavecurve::certified {

/// The real factors of smallest degree of the spectral factor q, |q(w)|^2 = P_N(sin^2(w/2)).
///
/// Each root y of P_N gives a reciprocal pair z + 1/z = 2 - 4y. A real y contributes the factor
/// 1 - z x, a conjugate pair of y the factor 1 - 2 Re(z) x + |z|^2 x^2, with z inside the unit
/// circle, scaled to the value 1 at x = 1. The choice of 1/z instead is the same factor with its
/// coefficients reversed. The roots y are isolated with proof (arb_fmpz_poly_complex_roots), real
/// ones first, then the pairs; within each kind by ascending real part, then imaginary part, of y.
std::vector<Polynomial<Ball>> halfband_factors(int order);

/// The real factors of smallest degree of P_N(y) itself, 1 - y/r of a real root r and
/// 1 - 2 Re(r) y / |r|^2 + y^2 / |r|^2 of a conjugate pair, in the same order.
std::vector<Polynomial<Ball>> halfband_factors_in_y(int order);

}  // namespace wavecurve::certified
