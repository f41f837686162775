#pragma once

#include <cstddef>
#include <cstdlib>
#include <span>
#include <utility>

#include "wavecurve/filters/filter.hpp"
#include "wavecurve/filters/square_matrix.hpp"

namespace wavecurve {

/// The index of the first unknown: 0 for even d; 1 for odd d, since an odd derivative of a
/// symmetric function vanishes at 0.
inline int first_two_scale_unknown(int d) { return d % 2; }

/// Throws as two_scale_matrix does.
void check_two_scale_arguments(int d, int coefficients);

/// Fills a square matrix of any type, of alpha.size() - 1 - first_two_scale_unknown(d) rows, with A
/// below; its arguments have been checked.
template <class Scalar, class Matrix>
void fill_two_scale_matrix(std::span<const Scalar> alpha, int d, Matrix& a) {
  const int first = first_two_scale_unknown(d), support = static_cast<int>(alpha.size()) - 1;
  const auto at = [&](int k) { return alpha[static_cast<std::size_t>(k)]; };
  Scalar scale = Scalar(1) / Scalar(2);
  for (int i = 0; i < d; ++i) scale *= Scalar(2);
  for (int l = first; l < support; ++l) {
    for (int m = first; m < support; ++m) {
      const int below = std::abs(2 * l - m), above = 2 * l + m;
      Scalar sum = below <= support ? at(below) : Scalar(0);
      if (m > 0 && above <= support) d % 2 == 0 ? sum += at(above) : sum -= at(above);
      sum *= scale;
      if (l == m) sum -= Scalar(1);
      a(l - first, m - first) = std::move(sum);
    }
  }
}

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
  SquareMatrix<Scalar> a(alpha.size() - 1 - first_two_scale_unknown(d));
  fill_two_scale_matrix(std::span<const Scalar>(alpha.taps), d, a);
  return a;
}

}  // namespace wavecurve
