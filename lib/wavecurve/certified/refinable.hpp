#pragma once

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/rational.hpp"
#include "wavecurve/filters/filter.hpp"

namespace wavecurve::certified {

// A refinable function f(x) = sum_k a_k f(2x - k) with sum a_k = 2 and int f = 1: the scaling
// function (a_k = sqrt 2 h_k), or its autocorrelation F(s) = int phi(x - s) phi(x) dx (a_k =
// alpha_k / 2). Derivatives obey
//   f^(d)(l) = 2^d sum_k a_k f^(d)(2l - k),                                               (R)
// so that the values at the integers are the eigenvector of (a_{2l-m}) for the eigenvalue 2^-d.
//
// The scale. If f reproduces polynomials up to degree d, sum_l l^d f(x - l) is a polynomial with
// leading term x^d int f = x^d; its d-th derivative is sum_l l^d f^(d)(x - l) = d!. At x = 0:
//   sum_l l^d f^(d)(l) = (-1)^d d!.                                                       (S)
// For the autocorrelation and d = 2 this reads sum_l l^2 mu_l = -2, since mu_l = -f''(l).
//
// The rank. Under the same condition (R) is singular from the left: its equations, each weighted by
// a polynomial p(l) of degree d, add up to nothing. For a symmetric f p(l) = l^d, so that the
// equation l = 0 carries no weight when d > 0 and must not be the one that (S) replaces: the others
// would still be dependent. The last equation carries weight. A regular system after the
// replacement proves that the other equations are independent; a null vector exists where f^(d)
// does, and the solution must obey the replaced equation too, which is checked (exactly for
// Rational, within the enclosures for Ball). Together: the rank of (R) is deficient by exactly one.

/// f^(d) at every integer of the support, by the system (R) with its last equation replaced by (S).
/// Scalar is Ball or Rational. Throws std::domain_error if the rank is not provably deficient by
/// one, which for Ball may be cured by a higher working precision.
template <class Scalar>
Filter<Scalar> derivative_at_integers(const Filter<Scalar>& mask, int d);

/// F^(d)(l) of the autocorrelation F for every l from -(P-1) to P-1, from alpha_0 .. alpha_P: half
/// the unknowns, since F is symmetric (filters/two_scale_matrix.hpp). Throws as above, and
/// std::invalid_argument for d outside 0 .. 16.
template <class Scalar>
Filter<Scalar> autocorrelation_derivative_at_integers(const Filter<Scalar>& alpha, int d);

}  // namespace wavecurve::certified
