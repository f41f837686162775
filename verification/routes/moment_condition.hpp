#pragma once

#include <cstddef>
#include <vector>

#include "wavecurve/filters/square_matrix.hpp"

namespace wavecurve::verification {

// What is asked about the matrix A of (3.11), filters/two_scale_matrix.hpp, for the orders (1, 1).
// Scalar is certified::Ball or certified::Rational.

/// A with one equation replaced by the moment condition, sum_l l^2 mu_l = -2 over all integers,
/// and its right-hand side.
template <class Scalar>
std::vector<Scalar> replace_by_moment_condition(SquareMatrix<Scalar>& a, int equation) {
  std::vector<Scalar> right_hand_side(static_cast<std::size_t>(a.size()));
  for (long l = 0; l < a.size(); ++l) a(equation, static_cast<int>(l)) = Scalar(2 * l * l);
  right_hand_side[static_cast<std::size_t>(equation)] = Scalar(-2);
  return right_hand_side;
}

/// The row vector (l^2) A.
template <class Scalar>
std::vector<Scalar> weighted_by_squares(const SquareMatrix<Scalar>& a) {
  std::vector<Scalar> sums(static_cast<std::size_t>(a.size()));
  for (long l = 0; l < a.size(); ++l) {
    for (int column = 0; column < a.size(); ++column) {
      sums[static_cast<std::size_t>(column)] += Scalar(l * l) * a(static_cast<int>(l), column);
    }
  }
  return sums;
}

}  // namespace wavecurve::verification
