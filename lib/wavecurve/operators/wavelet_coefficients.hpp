#pragma once

#include "wavecurve/filters/filter.hpp"

namespace wavecurve {

/// nu_l = 2^(d-1) sum_k beta_k mu_{2l+k} for every l of the wavelet's support, with d = p + q and
/// beta_k = 2 sum_i g_i g_{i+k} (k >= 0) of the synthesis high-pass filter. Publication, (3.12).
template <class Scalar>
Filter<Scalar> wavelet_coefficients(const Filter<Scalar>& mu, const Filter<Scalar>& beta, int d) {
  Scalar scale = Scalar(1) / Scalar(2);
  for (int i = 0; i < d; ++i) scale *= Scalar(2);
  const int last = (mu.last_index() + beta.last_index()) / 2;
  Filter<Scalar> nu{-last, {}};
  for (int l = -last; l <= last; ++l) {
    Scalar sum = beta[0] * mu[2 * l];
    for (int k = 1; k <= beta.last_index(); ++k) sum += beta[k] * (mu[2 * l + k] + mu[2 * l - k]);
    nu.taps.push_back(sum * scale);
  }
  return nu;
}

}  // namespace wavecurve
