#include "wavecurve/certified/connection_coefficients.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "wavecurve/certified/basis_function.hpp"
#include "wavecurve/certified/detail/derivative_over_taps.hpp"
#include "wavecurve/certified/detail/is_accurate.hpp"
#include "wavecurve/certified/detail/refine.hpp"
#include "wavecurve/certified/refinable.hpp"
#include "wavecurve/certified/sobolev_exponent.hpp"
#include "wavecurve/filters/autocorrelation.hpp"
#include "wavecurve/filters/connection_coefficients.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

void require_orders(int p, int q) {
  for (const int order : {p, q}) {
    check_between("derivative order", order, 0, highest_derivative);
  }
}

/// From F^(p+q) at the integers.
template <class Scalar>
ConnectionCoefficients<Scalar> from_derivative(Filter<Scalar> derivative,
                                               const Filter<Scalar>& beta, int p, int q) {
  ConnectionCoefficients<Scalar> result{p, q, std::move(derivative), {}};
  if (p % 2 != 0) {
    for (Scalar& value : result.mu.taps) value = -value;
  }
  result.nu = wavelet_coefficients(result.mu, beta, p + q);
  // An antisymmetric sequence is zero there; the enclosures of its two halves do not know that.
  if ((p + q) % 2 != 0) result.nu.taps[result.nu.taps.size() / 2] = Scalar(0);
  return result;
}

/// beta_k = (-1)^k alpha~_k of the analysis low-pass filter, since g_k = (-1)^k h~_{1-k} (3.13).
template <class Scalar>
Filter<Scalar> with_alternating_signs(Filter<Scalar> alpha) {
  for (std::size_t k = 1; k < alpha.taps.size(); k += 2) alpha.taps[k] = -alpha.taps[k];
  return alpha;
}

}  // namespace

ConnectionCoefficients<Ball> connection_coefficients(const FilterDefinition& definition, int p,
                                                     int q, long bits) {
  require_orders(p, q);
  require_smoothness(definition, p, q);
  constexpr long guard_bits = 64;
  ConnectionCoefficients<Ball> result;
  const auto attempt = [&](long working) {
    const FilterBank<Ball> bank = definition.bank(working);
    result = from_derivative(
        definition.known_bits
            ? autocorrelation_derivative_over(bank.synthesis_low, p + q)
            : autocorrelation_derivative_at_integers(autocorrelation(bank.synthesis_low), p + q),
        autocorrelation(bank.synthesis_high), p, q);
    return is_accurate(result.mu, bits) &&
           (definition.dual_known_bits || is_accurate(result.nu, bits));
  };
  // What the taps do not tell, no precision does.
  const std::optional<long> known = definition.known_bits;
  refine((known ? std::min(bits, *known) : bits) + guard_bits, attempt, known);
  return result;
}

bool is_accurate(const ConnectionCoefficients<Ball>& coefficients, long bits) {
  return is_accurate(coefficients.mu, bits) && is_accurate(coefficients.nu, bits);
}

std::optional<ConnectionCoefficients<Rational>> exact_connection_coefficients(
    const FilterDefinition& definition, int p, int q) {
  require_orders(p, q);
  if (!definition.exact) return std::nullopt;
  require_smoothness(definition, p, q);
  return from_derivative(autocorrelation_derivative_at_integers(definition.exact->synthesis, p + q),
                         with_alternating_signs(definition.exact->analysis), p, q);
}

}  // namespace wavecurve::certified
