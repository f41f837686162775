#pragma once

#include <string_view>
#include <vector>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/linear_solve.hpp"
#include "wavecurve/certified/rational.hpp"
#include "wavecurve/filters/filter.hpp"

namespace wavecurve::verification {

/// The matrix A of the publication's A mu = 0, (3.11), P = alpha.size() - 1;
/// operators/two_scale_system.hpp has it in double precision.
template <class Scalar>
certified::SquareMatrix<Scalar> exact_reduced_system(const Filter<Scalar>& alpha) {
  const int unknowns = alpha.size() - 1;
  certified::SquareMatrix<Scalar> a(unknowns);
  for (int l = 0; l < unknowns; ++l) {
    a(l, l) -= Scalar(1);
    for (int k = -unknowns; k <= unknowns; ++k) {
      const int shifted = 2 * l + k < 0 ? -(2 * l + k) : 2 * l + k;  // mu_{-l} = mu_l
      const Scalar alpha_k = alpha[k < 0 ? -k : k];
      if (shifted < unknowns) a(l, shifted) += alpha_k + alpha_k;
    }
  }
  return a;
}

/// A with one equation replaced by the moment condition, sum_l l^2 mu_l = -2 over all integers,
/// and its right-hand side.
template <class Scalar>
std::vector<Scalar> replace_by_moment_condition(certified::SquareMatrix<Scalar>& a, int equation) {
  std::vector<Scalar> right_hand_side(static_cast<std::size_t>(a.size()));
  for (long l = 0; l < a.size(); ++l) a(equation, static_cast<int>(l)) = Scalar(2 * l * l);
  right_hand_side[static_cast<std::size_t>(equation)] = Scalar(-2);
  return right_hand_side;
}

/// The row vector (l^2) A.
template <class Scalar>
std::vector<Scalar> weighted_by_squares(const certified::SquareMatrix<Scalar>& a) {
  std::vector<Scalar> sums(static_cast<std::size_t>(a.size()));
  for (long l = 0; l < a.size(); ++l) {
    for (int column = 0; column < a.size(); ++column) {
      sums[static_cast<std::size_t>(column)] += Scalar(l * l) * a(static_cast<int>(l), column);
    }
  }
  return sums;
}

}  // namespace wavecurve::verification
