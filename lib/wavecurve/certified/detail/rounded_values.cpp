#include "wavecurve/certified/detail/rounded_values.hpp"

#include <utility>

#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

Ball largest_of(const std::vector<Ball>& values) {
  Ball largest(0);
  for (const Ball& value : values) {
    const Ball size = abs(value.midpoint());
    if (certainly_less(largest, size)) largest = size;
  }
  return largest;
}

/// Nothing if one of the numbers is not decided, and a higher precision may decide it.
std::optional<std::vector<DecimalEnclosure>> rounded(const std::vector<Ball>& values, int digits,
                                                     bool is_last) {
  const Ball negligible =
      largest_of(values) / pow(Ball(10), static_cast<unsigned long>(digits + 100));
  std::vector<DecimalEnclosure> result;
  for (const Ball& value : values) {
    auto decimal = decimal_enclosure(value, digits);
    const bool may_vanish = value.contains_zero() && certainly_less(value.radius(), negligible);
    if (!decimal && !may_vanish && !is_last) return std::nullopt;
    result.push_back(decimal ? std::move(*decimal) : supported_decimal(value, digits));
  }
  return result;
}

}  // namespace

std::vector<DecimalEnclosure> rounded_values(
    const std::function<std::vector<Ball>(long bits)>& compute, int digits,
    std::optional<long> known_bits) {
  check_at_least("number of significant digits", digits, 1);
  constexpr int most_attempts = 6;
  for (int attempt = 1;; ++attempt) {
    const long bits = bits_for_digits(digits) << (attempt - 1);
    const std::vector<Ball> values = compute(bits);
    const WorkingPrecision precision(2 * bits + 64);
    const bool is_last = attempt == most_attempts || (known_bits && bits > *known_bits);
    if (auto result = rounded(values, digits, is_last)) return *result;
  }
}

}  // namespace wavecurve::certified
