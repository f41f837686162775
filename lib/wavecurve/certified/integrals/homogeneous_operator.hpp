#pragma once

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/filters/filter.hpp"

namespace wavecurve::certified {

// Convolution operators without compact support, in the basis of phi (Beylkin 1992, IV and V):
//   r_l = int phi(x - l) (T phi)(x) dx,   (T f)(x) = int K(x - y) f(y) dy,
// with a kernel of degree -s-1, K(t) = 1/(pi t) (Hilbert transform, principal value, s = 0) or
// K(t) = t^(-s-1) / Gamma(-s) for t > 0, else 0 (derivative of order s, integral of order -s, from
// minus infinity).
//
// With the correlation F(u) = int phi(x) phi(x - u) dx, of support [-W, W] and two-scale
// coefficients c_k,
//   r_l = int K(t) F(t - l) dt = 2^s sum_k c_k r_{2l+k},   c_k = 1/2 sum_i a_i a_{i+k}.       (R)
// That system has infinitely many unknowns; it is closed in three steps.
//   1. Far off, l > W, Taylor's series of K about l meets the moments of F:
//        r_l = sum_{m<M} K^(m)(l) / m! int u^m F(u) du + R,
//        |R| <= sup_{|t-l|<=W} |K^(M)(t)| / M! W^M int |F|,
//        int |F| <= (int |phi|)^2 <= W int phi^2.
//   2. From there (R) runs downwards to l > W, since then 2l + k > l.
//   3. The rest, |l| <= W, is a small system, solved as enclosures; that proves it regular.
//      Its matrix 1 - 2^s C is singular for s = 0, 1, 2, ..: derivatives, which are integrals of
//      products. The Hilbert transform is odd; the system of odd sequences is regular for s = 0.

/// What is known of an operator.
struct HomogeneousOperator {
  enum class Kind { hilbert, fractional };
  Kind kind = Kind::hilbert;
  Rational order = Rational(0);  ///< s of a fractional derivative
};

/// r_l for |l| <= largest, to this many bits relative to the largest of them, as far as the
/// definition allows. Throws std::domain_error if phi is not known to be smooth enough (its Sobolev
/// exponent must exceed s/2, as for int phi T phi in the frequency domain); std::invalid_argument
/// for a whole order s >= 0, which is a derivative, for an order above highest_derivative, and for
/// largest outside 0 .. largest_shift.
Filter<Ball> operator_coefficients(const FilterDefinition& definition,
                                   const HomogeneousOperator& op, int largest, long bits);

inline constexpr int largest_shift = 100'000;

/// The same for functions of a whole period n, the operator being applied to each frequency k != 0 by its
/// symbol, sgn(k) / i or (2 pi i k / n)^s, and mapping constants to 0 (Weyl):
///   r_l = sum_j r_{l + n j} = 1/n sum_{k != 0} |phi^(2 pi k / n)|^2 symbol(k) e^(2 pi i k l / n),
/// l = 0 .. n - 1, k over all whole numbers; the first column of a circulant matrix. The sum over j is taken term
/// by term of Taylor's series above, which gives Hurwitz' zeta functions, with its remainder. For orders s <= 0
/// it diverges, and the zeta functions continue it: both sides are analytic in s. The bits are relative to the r_0 and
/// r_1 of the line. Throws as above, and for a
/// period outside 1 .. largest_operator_period.
Filter<Ball> periodic_operator_coefficients(const FilterDefinition& definition,
                                            const HomogeneousOperator& op, int period, long bits);

inline constexpr int largest_operator_period = 16'384;

}  // namespace wavecurve::certified
