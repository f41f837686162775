#pragma once

#include <array>

#include "wavecurve/certified/ball.hpp"

namespace wavecurve::certified {

// Bounds of the elementary functions' errors, in units in the last place of the true value. Proved
// on pieces that cover the reduced range: the approximation error is enclosed, the rounding errors
// are bounded operation by operation (rounded_ball.hpp), and half a unit is added for the last
// addition, head + tail.
//
// That is enough also where head + tail rounds up to the next power of two, where doubles are twice
// as far apart as below: if the true value y lies below 2^k and head + tail, within less than a unit
// of y, does not, then 2^k is the nearest double of head + tail, and nearer to y than it is.

/// The coefficients, and how far each polynomial may be from its series.
struct ElementaryPolynomials {
  std::array<double, 7> sine;
  std::array<double, 6> cosine;
  std::array<double, 11> exponential;
  std::array<double, 8> logarithm;
  std::array<double, 13> arctangent;
  double sine_distance, cosine_distance, exponential_distance, logarithm_distance,
      arctangent_distance;
};
ElementaryPolynomials elementary_polynomials();

/// The ends of the reduced ranges: pi/4 and log(2)/2, and what rounding adds to the quotient by
/// pi/2 or log(2) before it is rounded to an integer. A quotient below 2^20 errs by 2^-32 at most,
/// one below 2^11 by 2^-41.
Ball largest_angle();
Ball largest_reduced_exponent();

/// log(2) as a sum of 42 bits, so that the multiples that occur are doubles, and a double.
struct TwoParts {
  double head, tail;
};
TwoParts parts_of_log_2();

/// No double beyond pi/4 is nearer to a multiple of pi/2 than this. A double is m 2^e with m < 2^53,
/// and of all such m the denominator of a convergent of 2^e / (pi/2) comes nearest.
double least_distance_to_quarter_turn();

/// An angle's reduction errs by 2^-125 at most and by 2^-103 of the reduced angle (see
/// elementary_bounds.cpp), together by less than this part of it.
double reduction_error();

struct ElementaryBounds {
  double sine = 0, cosine = 0, exponential = 0, exponential_minus_one = 0, logarithm = 0,
         arctangent = 0;
};
ElementaryBounds elementary_bounds(const ElementaryPolynomials& polynomials);

/// arctan(j / 32), j = first .. 32, as head and tail.
constexpr int first_arctangent = 14;
TwoParts parts_of_arctangent(int j);
TwoParts two_doubles(const Ball& x);

}  // namespace wavecurve::certified
