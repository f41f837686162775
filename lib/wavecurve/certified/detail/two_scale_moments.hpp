#pragma once

#include <vector>

#include "wavecurve/filters/filter.hpp"
#include "wavecurve/filters/two_scale_matrix.hpp"

namespace wavecurve::certified {

// The equation (S) of certified/refinable.hpp, which gives the null vector of the two-scale system
// its scale, for Ball and Rational.

template <class Scalar>
Scalar integer_power(long base, int exponent) {
  Scalar result(1);
  for (int i = 0; i < exponent; ++i) result *= Scalar(base);
  return result;
}

/// (-1)^d d!, the right-hand side of (S).
template <class Scalar>
Scalar moment(int d) {
  Scalar result(1);
  for (int i = 1; i <= d; ++i) result *= Scalar(-i);
  return result;
}

/// The weights of (S) for the unknowns F^(d)(m), m = first_two_scale_unknown(d) .. last: those of m
/// and -m together.
template <class Scalar>
std::vector<Scalar> moment_weights(int last, int d) {
  std::vector<Scalar> weights;
  for (int m = first_two_scale_unknown(d); m <= last; ++m) {
    weights.push_back(integer_power<Scalar>(m, d) * Scalar(m == 0 ? 1 : 2));
  }
  return weights;
}

/// F^(d)(m) for m = -last .. last from the unknowns.
template <class Scalar>
Filter<Scalar> mirrored(const std::vector<Scalar>& unknowns, int last, int d) {
  const int first = first_two_scale_unknown(d);
  Filter<Scalar> values{-last,
                        std::vector<Scalar>(static_cast<std::size_t>(2 * last + 1), Scalar(0))};
  for (int m = first; m <= last; ++m) {
    const Scalar& value = unknowns[static_cast<std::size_t>(m - first)];
    values.taps[static_cast<std::size_t>(last - m)] = d % 2 != 0 ? -value : value;
    values.taps[static_cast<std::size_t>(last + m)] = value;
  }
  return values;
}

}  // namespace wavecurve::certified
