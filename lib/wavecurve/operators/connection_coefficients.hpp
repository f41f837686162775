#pragma once

#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/operators/two_scale_system.hpp"

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

/// In double precision; certified::connection_coefficients gives enclosures.
/// Throws std::domain_error if phi is not smooth enough for the integrals to exist: the Sobolev
/// exponent must exceed (p + q) / 2. Throws std::invalid_argument for p or q outside 0 .. 8.
ConnectionCoefficients<double> connection_coefficients(
    const FilterBank<double>& bank, int p = 1, int q = 1,
    NullVectorMethod method = NullVectorMethod::constrained);

}  // namespace wavecurve
