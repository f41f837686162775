#include "wavecurve/certified/decimal_enclosure.hpp"

#include "wavecurve/certified/rounding.hpp"

namespace wavecurve::certified {

namespace {

std::string distance_bound(const Ball& x, const std::string& decimal) {
  return magnitude_bound(x - Ball(Rational::from_decimal(decimal)));
}

}  // namespace

DecimalEnclosure decimal_enclosure(const Rational& x, int digits) {
  const std::string value = round_to_digits(x, digits);
  const Rational error = x - Rational::from_decimal(value);
  return {value, error.is_zero() ? "0" : magnitude_bound(Ball(error)), x.to_string()};
}

std::optional<DecimalEnclosure> decimal_enclosure(const Ball& x, int digits) {
  if (x.is_exact() && x.contains_zero()) return DecimalEnclosure{"0", "0", "0"};
  const auto value = round_to_digits(x, digits);
  if (!value) return std::nullopt;
  return DecimalEnclosure{*value, distance_bound(x, *value), std::nullopt};
}

DecimalEnclosure supported_decimal(const Ball& x, int digits) {
  for (int supported = digits; supported >= 1; --supported) {
    if (auto decimal = decimal_enclosure(x, supported)) return *decimal;
  }
  return {"0", magnitude_bound(x), std::nullopt};
}

}  // namespace wavecurve::certified
