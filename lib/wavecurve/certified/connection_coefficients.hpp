#pragma once

#include <optional>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/certified/rational.hpp"
#include "wavecurve/filters/connection_coefficients.hpp"

namespace wavecurve::certified {

// Connection coefficients mu_l, nu_l (see filters/connection_coefficients.hpp) with proof.
//
// Both follow from the autocorrelation F(s) = int phi(x - s) phi(x) dx. Integrating by parts p
// times,
//   mu_l = int phi^(p)(x - l) phi^(q)(x) dx = (-1)^p F^(p+q)(l),
// and F is refinable with the mask alpha_k / 2 (certified/refinable.hpp). With
// beta_k = 2 sum_i g_i g_{i+k} of the synthesis high-pass filter (3.12) is
//   nu_l = 2^(p+q-1) sum_k beta_k mu_{2l+k}.
// A solution proves that the two-scale system has rank deficiency exactly one.

/// Enclosures of at least this many bits of relative accuracy, as far as the definition allows.
/// Throws std::domain_error if the family is not smooth enough, naming the exponents;
/// std::invalid_argument for p or q outside 0 .. 8.
ConnectionCoefficients<Ball> connection_coefficients(const FilterDefinition& definition, int p,
                                                     int q, long bits);

/// Whether the enclosures of mu, and those of nu, have this many bits relative to the largest of
/// them. connection_coefficients() falls short of the bits asked for only where the taps do.
bool is_accurate(const ConnectionCoefficients<Ball>& coefficients, long bits);

/// The exact fractions, for families with rational autocorrelations (Daubechies, symlets, splines);
/// empty for others. Throws as above.
std::optional<ConnectionCoefficients<Rational>> exact_connection_coefficients(
    const FilterDefinition& definition, int p, int q);

}  // namespace wavecurve::certified
