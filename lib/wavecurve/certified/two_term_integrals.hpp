#pragma once

#include "wavecurve/certified/basis_function.hpp"

namespace wavecurve::certified {

// Two-term connection coefficients of any two functions of a filter bank, with proof:
//   I_l = int f(x) g(x - l) dx,   f, g any derivatives of phi, psi, phi~, psi~.
//
// For two scaling functions s, t with the two-scale coefficients a, b the correlation
//   F(u) = int s(x) t(x - u) dx   is refinable,   F(u) = sum_k c_k F(2u - k),
//   c_k = 1/2 sum_i a_i b_{i-k},   sum_k c_k = 2,   int F = 1,
// and integrating by parts, int s^(p)(x) t^(q)(x - l) dx = (-1)^q F^(p+q)(l), whose values at the
// integers certified/refinable.hpp proves. With J_l this integral and a, b now the two-scale
// coefficients of f and g,
//   I_l = 2^(p+q-1) sum_k (sum_i a_i b_{i-k}) J_{2l-k}
// takes any of the two to its wavelet; for scaling functions it is the two-scale relation itself.
//
// Beylkin, "On the representation of operators in bases of compactly supported wavelets" (1992),
// has r_l = int phi(x - l) phi'(x) dx, which is f = phi', g = phi. The publication has
// mu_l: f = g = phi', and nu_l: f = g = psi', (3.10)-(3.14).

/// I_l for every integer l where the supports meet, to this many bits relative to the largest, as
/// far as the definition allows. Throws std::domain_error, naming the exponents, unless the sum of
/// the two Sobolev exponents is proved positive, which the integrals need (for f = g they exist in
/// no other case); std::invalid_argument for a derivative outside 0 .. highest_derivative.
Filter<Ball> two_term_integrals(const FilterDefinition& definition, const BasisFunction& f,
                                const BasisFunction& g, long bits);

/// Throws as two_term_integrals does where the integrals are not known to exist.
void require_integrable_product(const FilterDefinition& definition, const BasisFunction& f,
                                const BasisFunction& g);

}  // namespace wavecurve::certified
