#pragma once

#include "wavecurve/filters/filter.hpp"

namespace wavecurve {

/// Connection coefficients of the scaling function and of the wavelet, for derivative orders p, q:
///   mu_l = int phi^(p)(x - l) phi^(q)(x) dx,   nu_l = int psi^(p)(x - l) psi^(q)(x) dx,
/// phi and psi those of the synthesis side. Both are symmetric in l for even p + q, antisymmetric
/// for odd p + q, and are stored for every l of their support (mu[l] is 0 outside).
/// Stiffness is (1, 1), mass (0, 0), advection (0, 1), bending (2, 2).
/// Publication, section 3.2, (3.10)-(3.14).
template <class Scalar = double>
struct ConnectionCoefficients {
  int p = 1, q = 1;
  Filter<Scalar> mu, nu;
};

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
