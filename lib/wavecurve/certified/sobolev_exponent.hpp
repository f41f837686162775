#pragma once

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/filter_definition.hpp"

namespace wavecurve::certified {

/// The Sobolev exponent s of the scaling function of a low-pass filter (sum sqrt 2) with N zeros at
/// w = pi: phi lies in H^r for r < s and, where its integer shifts form a Riesz basis, for no r >
/// s.
///
///   low(x) = sqrt 2 ((1 + x)/2)^N q(x),   |q|^2 <-> a_k = sum_i q_i q_{i+k},
///   s = N - log_4 rho,  rho the spectral radius of the transition operator (T u)_i = 2 sum_j
///   a_{2i-j} u_j
/// on sequences over |i| <= deg q - 1 (Eirola 1992; Villemoes 1992). T maps symmetric sequences to
/// such, and its spectral radius is attained there. It is enclosed from both sides by the trace and
/// the norm of T^k, k = 1, 2, 4 .. 2^squarings; the radius of the result halves with each squaring,
/// until the enclosures of the taps, or the working precision, give no more. The squarings are
/// bounded to about a second of work, so that the result for hundreds of taps beyond the zeros is
/// less accurate. Throws std::domain_error if low does not have N zeros at pi within its
/// enclosures, or if they are too wide for any bound.
Ball sobolev_exponent(const Filter<Ball>& low, int zeros_at_pi, int squarings);

/// The exponent of phi, with a radius below 1e-13 if taps and bound of the work allow. For the dual
/// scaling function pass dual(definition); a negative exponent says that it is no square-integrable
/// function.
Ball sobolev_exponent(const FilterDefinition& definition);

/// Whether the exponent of phi is proved to exceed the given one. It often takes less work than the
/// exponent. Throws std::domain_error if nothing is known of it.
bool is_proved_smoother(const FilterDefinition& definition, const Rational& exponent);

/// Throws std::domain_error, naming the exponent found and the one needed, unless the exponent is
/// proved to exceed (p + q) / 2, which the integrals of phi^(p) phi^(q) need.
void require_smoothness(const FilterDefinition& definition, int p, int q);

}  // namespace wavecurve::certified
