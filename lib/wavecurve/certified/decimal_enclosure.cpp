#include "wavecurve/certified/decimal_enclosure.hpp"

#include <algorithm>
#include <cmath>

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
  // A digit takes log2(10) bits; no more than one digit beyond the accurate ones may be decided.
  const double accurate = static_cast<double>(x.accuracy_bits()) * std::log10(2.0);
  const int most = accurate + 2 < digits ? std::max(1, static_cast<int>(accurate) + 2) : digits;
  for (int supported = most; supported >= 1; --supported) {
    if (auto decimal = decimal_enclosure(x, supported)) return *decimal;
  }
  return {"0", magnitude_bound(x), std::nullopt};
}

}  // namespace wavecurve::certified
