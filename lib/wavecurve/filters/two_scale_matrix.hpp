#pragma once

#include "wavecurve/filters/filter.hpp"
#include "wavecurve/filters/square_matrix.hpp"

namespace wavecurve {

/// The index of the first unknown: 0 for even d; 1 for odd d, since an odd derivative of a
/// symmetric function vanishes at 0.
inline int first_two_scale_unknown(int d) { return d % 2; }

/// Throws as two_scale_matrix does.
void check_two_scale_arguments(int d, int coefficients);

/// Beylkin's two-scale matrix A, (3.11) of the publication, one row an equation. A mu = 0 says
///   mu_l = 2^(d-1) sum_k alpha_k mu_{2l+k},   mu_{-l} = (-1)^d mu_l,   mu_l = 0 for |l| >= P
/// for the integrals mu_l of derivatives whose orders add up to d, (3.10), or any multiple of them.
/// alpha_0 .. alpha_P is the autocorrelation (filters/autocorrelation.hpp), P the support width.
/// The unknowns are mu_l, l = first_two_scale_unknown(d) .. P-1, so that
///   A_lm = 2^(d-1) (alpha_{2l-m} + (-1)^d alpha_{2l+m}) - delta_lm,   the second term for m > 0.
///
/// Scalar is double, certified::Ball (at the working precision) or certified::Rational. Throws
/// std::invalid_argument if alpha is too short for one unknown, or d lies outside 0 .. 16.
template <class Scalar>
SquareMatrix<Scalar> two_scale_matrix(const Filter<Scalar>& alpha, int d = 2) {
  check_two_scale_arguments(d, alpha.size());
  const int first = first_two_scale_unknown(d), unknowns = alpha.size() - 1 - first;
  Scalar scale = Scalar(1) / Scalar(2);
  for (int i = 0; i < d; ++i) scale *= Scalar(2);
  const auto at = [&](int k) { return alpha[k < 0 ? -k : k]; };
  SquareMatrix<Scalar> a(unknowns);
  for (int row = 0; row < unknowns; ++row) {
    const int l = first + row;
    for (int column = 0; column < unknowns; ++column) {
      const int m = first + column;
      Scalar sum = at(2 * l - m);
      if (m > 0) d % 2 == 0 ? sum += at(2 * l + m) : sum -= at(2 * l + m);
      a(row, column) = scale * sum - Scalar(row == column ? 1 : 0);
    }
  }
  return a;
}

}  // namespace wavecurve
