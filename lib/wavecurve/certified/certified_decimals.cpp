#include "wavecurve/certified/certified_decimals.hpp"

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "wavecurve/certified/autocorrelation.hpp"
#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/detail/refine.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

void require_sense(const DecimalsRequest& request) {
  check_at_least("number of significant digits", request.digits, 1);
  if (request.divide_by_first && (request.p + request.q) % 2 != 0) {
    throw std::invalid_argument("the coefficient of index 0 is zero for the odd sum " +
                                std::to_string(request.p + request.q) +
                                " of derivative orders, and nothing can be divided by it");
  }
}

template <class Scalar>
struct Sequences {
  std::vector<Scalar> alpha, mu, nu;
};

template <class Scalar>
std::vector<Scalar> from_index_zero(const Filter<Scalar>& symmetric, bool divide_by_first) {
  std::vector<Scalar> values;
  for (int l = 0; l <= symmetric.last_index(); ++l) {
    values.push_back(divide_by_first ? symmetric[l] / symmetric[0] : symmetric[l]);
  }
  return values;
}

template <class Scalar>
Sequences<Scalar> sequences(const Filter<Scalar>& alpha,
                            const ConnectionCoefficients<Scalar>& coefficients,
                            bool divide_by_first) {
  return {alpha.taps, from_index_zero(coefficients.mu, divide_by_first),
          from_index_zero(coefficients.nu, divide_by_first)};
}

/// Each number by `round`; empty as soon as that answers with nothing.
template <class Scalar, class Round>
std::optional<CoefficientDecimals> rounded(const Sequences<Scalar>& numbers, Round round) {
  CoefficientDecimals decimals;
  for (const auto& [from, to] :
       {std::pair{&numbers.alpha, &decimals.alpha}, std::pair{&numbers.mu, &decimals.mu},
        std::pair{&numbers.nu, &decimals.nu}}) {
    for (const Scalar& number : *from) {
      std::optional<DecimalEnclosure> decimal = round(number);
      if (!decimal) return std::nullopt;
      to->push_back(std::move(*decimal));
    }
  }
  return decimals;
}

/// The same definition, which gives a bank that it has made before if that is as accurate.
FilterDefinition remembering(FilterDefinition definition) {
  definition.bank = [make = definition.bank, most = std::make_shared<FilterBank<Ball>>(),
                     most_bits = std::make_shared<long>(-1)](long bits) {
    if (bits > *most_bits) {
      *most = make(bits);
      *most_bits = bits;
    }
    return *most;
  };
  return definition;
}

CoefficientDecimals from_enclosures(const FilterDefinition& of, const DecimalsRequest& request) {
  const FilterDefinition definition = remembering(of);
  std::optional<CoefficientDecimals> decimals;
  refine(bits_for_digits(request.digits), [&](long bits) {
    const auto coefficients = connection_coefficients(definition, request.p, request.q, bits);
    const auto numbers =
        sequences(autocorrelation(definition, bits), coefficients, request.divide_by_first);
    decimals =
        rounded(numbers, [&](const Ball& x) { return decimal_enclosure(x, request.digits); });
    if (decimals) return true;
    decimals = rounded(numbers, [&](const Ball& x) {
      return std::optional(supported_decimal(x, request.digits));
    });
    // The taps have no more bits to give, and a higher precision would not help.
    return !is_accurate(coefficients, bits);
  });
  return *decimals;
}

}  // namespace

CoefficientDecimals certified_decimals(const FilterDefinition& definition,
                                       const DecimalsRequest& request) {
  require_sense(request);
  const auto exact = exact_connection_coefficients(definition, request.p, request.q);
  if (!exact) return from_enclosures(definition, request);
  return *rounded(
      sequences(definition.exact->synthesis, *exact, request.divide_by_first),
      [&](const Rational& x) { return std::optional(decimal_enclosure(x, request.digits)); });
}

}  // namespace wavecurve::certified
