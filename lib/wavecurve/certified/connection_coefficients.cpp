#include "wavecurve/certified/connection_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "wavecurve/certified/refinable.hpp"
#include "wavecurve/certified/sobolev_exponent.hpp"
#include "wavecurve/filters/autocorrelation.hpp"
#include "wavecurve/filters/connection_coefficients.hpp"

namespace wavecurve::certified {

namespace {

constexpr int highest_derivative = 8;

void require_orders(int p, int q) {
  for (const int order : {p, q}) {
    if (order < 0 || order > highest_derivative) {
      throw std::invalid_argument("derivative order " + std::to_string(order) +
                                  ": must lie in 0 .. " + std::to_string(highest_derivative));
    }
  }
}

template <class Scalar>
ConnectionCoefficients<Scalar> from_autocorrelations(const Filter<Scalar>& alpha,
                                                     const Filter<Scalar>& beta, int p, int q) {
  ConnectionCoefficients<Scalar> result{
      p, q, autocorrelation_derivative_at_integers(alpha, p + q), {}};
  if (p % 2 != 0) {
    for (Scalar& value : result.mu.taps) value = -value;
  }
  result.nu = wavelet_coefficients(result.mu, beta, p + q);
  return result;
}

/// beta_k = (-1)^k alpha~_k of the analysis low-pass filter, since g_k = (-1)^k h~_{1-k} (3.13).
template <class Scalar>
Filter<Scalar> with_alternating_signs(Filter<Scalar> alpha) {
  for (std::size_t k = 1; k < alpha.taps.size(); k += 2) alpha.taps[k] = -alpha.taps[k];
  return alpha;
}

/// A coefficient that is nearly zero may be known only absolutely; the largest sets the scale.
bool accurate(const Filter<Ball>& values, long bits) {
  double largest = 0, radius = 0;
  for (const Ball& value : values.taps) {
    largest = std::max(largest, std::abs(value.to_double()));
    radius = std::max(radius, value.radius_double());
  }
  return radius <= std::ldexp(largest, static_cast<int>(-bits));
}

}  // namespace

ConnectionCoefficients<Ball> connection_coefficients(const FilterDefinition& definition, int p,
                                                     int q, long bits) {
  require_orders(p, q);
  require_smoothness(definition, p, q);
  constexpr long guard_bits = 64;
  constexpr int doublings = 5;
  long working = bits + guard_bits;
  for (int attempt = 0;; ++attempt, working *= 2) {
    const WorkingPrecision precision(working);
    try {
      const FilterBank<Ball> bank = definition.bank(working);
      const auto alpha = autocorrelation(bank.synthesis_low);
      const auto beta = autocorrelation(bank.synthesis_high);
      auto result = from_autocorrelations(alpha, beta, p, q);
      if ((accurate(result.mu, bits) && accurate(result.nu, bits)) || attempt == doublings)
        return result;
    } catch (const std::domain_error&) {
      if (attempt == doublings) throw;
    }
  }
}

std::optional<ConnectionCoefficients<Rational>> exact_connection_coefficients(
    const FilterDefinition& definition, int p, int q) {
  require_orders(p, q);
  if (!definition.exact) return std::nullopt;
  require_smoothness(definition, p, q);
  return from_autocorrelations(definition.exact->synthesis,
                               with_alternating_signs(definition.exact->analysis), p, q);
}

}  // namespace wavecurve::certified
