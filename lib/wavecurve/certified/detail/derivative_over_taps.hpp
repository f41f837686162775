#pragma once

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/filters/filter.hpp"

namespace wavecurve::certified {

// What autocorrelation_derivative_at_integers (certified/refinable.hpp) computes, for all filters
// whose taps lie in given intervals, h_i = c_i + r_i e_i with |e_i| <= 1, as tightly as these allow.
//
// The autocorrelation is a polynomial in the e_i,
//   alpha_k = alpha_k(c) + sum_i 2 r_i (c_{i+k} + c_{i-k}) e_i + 2 sum_i r_i r_{i+k} e_i e_{i+k},
// and the system M(alpha) x = b, (R) with its last equation replaced by (S), is linear in alpha. Let
// x~ be the solution for the middle c, and Y the inverse there, both approximate. The true
// x = x~ + y of a filter in the box has M y = b - M x~, so that with E = 1 - Y M
//   y = z + E y,   z = Y (b - M(alpha) x~),   |y - z|_l <= |E|_l max|z| / (1 - max|E|),
// |E|_l the sum over row l, for all of the box at once. E is small, of the size of the radii, and z
// is the polynomial above under one linear map: its terms of first order are added up tap by tap,
// which keeps what belongs together. (An interval elimination forgets that one tap is in many
// entries of M, and loses seven digits with a filter of 18 taps.) max|E| < 1 proves M regular for
// every filter of the box.

/// Encloses F^(d)(l), l from -(P-1) to P-1, P + 1 taps, for every filter in the box for which the
/// system has a solution. Throws std::domain_error if the taps are known too badly for that.
Filter<Ball> autocorrelation_derivative_over(const Filter<Ball>& taps, int d);

}  // namespace wavecurve::certified
