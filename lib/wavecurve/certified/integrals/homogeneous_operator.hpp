#pragma once

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/filters/filter.hpp"

namespace wavecurve::certified {

// Convolution operators without compact support, in the basis of phi (Beylkin 1992, IV and V):
//   r_l = int phi(x - l) (T phi)(x) dx,   (T f)(x) = int K(x - y) f(y) dy,
// with a kernel of degree -s-1, which belongs to a symbol of degree s:
//   (i w)^s            K(t) = t^(-s-1) / Gamma(-s) for t > 0, else 0: derivative of order s, integral of
//                      order -s from minus infinity
//   |w|^s              K(t) = -Gamma(s+1) sin(pi s/2) / pi |t|^(-s-1): Riesz' derivative (-d^2/dx^2)^(s/2),
//                      his potential for s < 0
//   -i sgn(w) |w|^s    K(t) = Gamma(s+1) cos(pi s/2) / pi sgn(t) |t|^(-s-1): Hilbert transform of that, itself
//                      for s = 0, 1/(pi t)
// as finite parts. Every homogeneous symbol of degree s is a sum of the last two.
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
//      products. An even kernel needs even sequences only, for which it is singular for even s, where
//      |w|^s is a derivative; an odd one odd sequences, and odd s.

/// What is known of an operator.
struct HomogeneousOperator {
  enum class Kind { hilbert, fractional, riesz };
  Kind kind = Kind::hilbert;
  Rational order = Rational(0);  ///< s
};

/// r_l for |l| <= largest, to this many bits relative to the largest of them, as far as the
/// definition allows. Throws std::domain_error if phi is not known to be smooth enough (its Sobolev
/// exponent must exceed s/2, as for int phi T phi in the frequency domain); std::invalid_argument
/// where the operator is a derivative (fractional and a whole s >= 0, riesz and an even s, hilbert
/// and an odd one), for an order above highest_derivative, for one below -highest_derivative
/// (fractional) or not above -1 (the others, whose kernels grow from there on), and for largest outside
/// 0 .. largest_shift.
Filter<Ball> operator_coefficients(const FilterDefinition& definition,
                                   const HomogeneousOperator& op, int largest, long bits);

inline constexpr int largest_shift = 100'000;

/// The same for functions of a whole period n, the operator being applied to each frequency k != 0 by its
/// symbol at w = 2 pi k / n, and mapping constants to 0 (Weyl):
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
