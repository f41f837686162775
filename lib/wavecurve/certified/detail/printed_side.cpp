#include "wavecurve/certified/detail/printed_side.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

constexpr int most_taps = 256, furthest_index = 10000, most_digits = 1000;

/// The exponent behind "e"; from_decimal has found it to be one.
long printed_exponent(std::string_view decimal) {
  const auto e = decimal.find_first_of("eE");
  if (e == std::string_view::npos) return 0;
  std::string_view digits = decimal.substr(e + 1);
  if (digits.starts_with('+')) digits.remove_prefix(1);
  long exponent = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  return exponent;
}

Rational decimal_value(const std::string& text) {
  check_between("the number of characters of " + value_text(text), static_cast<long>(text.size()),
                1, most_digits);
  const Rational value = Rational::from_decimal(text);
  check_between("the exponent of " + value_text(text), printed_exponent(text), -most_digits,
                most_digits);
  return value;
}

/// A decimal, or a fraction of two.
Rational exact_value(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return decimal_value(text);
  const Rational divisor = decimal_value(text.substr(slash + 1));
  if (divisor.is_zero()) {
    throw std::invalid_argument(value_text(text) + " is divided by zero");
  }
  return decimal_value(text.substr(0, slash)) / divisor;
}

/// Half a unit of the last printed digit: "0.125" -> 0.0005, "3e-4" -> 0.00005. A fraction is
/// exact.
Rational half_unit(const std::string& text) {
  if (text.find('/') != std::string::npos) return Rational(0);
  const std::string mantissa = text.substr(0, text.find_first_of("eE"));
  const auto point = mantissa.find('.');
  const long decimals =
      point == std::string::npos ? 0 : static_cast<long>(mantissa.size() - point) - 1;
  return Rational::from_decimal("1e" + std::to_string(printed_exponent(text) - decimals)) /
         Rational(2);
}

Rational checked_accuracy(const std::string& text) {
  const Rational accuracy = decimal_value(text);
  if (accuracy > Rational(0) && accuracy < Rational(1)) return accuracy;
  throw std::invalid_argument(must_be("accuracy", std::string_view(text), "above 0 and below 1"));
}

/// Takes off zeros at either end, and says what is wrong with what is left.
Filter<Rational> trimmed(const std::string& whose, Filter<Rational> filter,
                         std::vector<Rational>& radii) {
  const auto is_tap = [](const Rational& tap) { return !tap.is_zero(); };
  auto& taps = filter.taps;
  const auto first = std::ranges::find_if(taps, is_tap) - taps.begin();
  const auto last = std::find_if(taps.rbegin(), taps.rend(), is_tap).base() - taps.begin();
  check_between("the number of taps" + whose, std::max<long>(0, last - first), 1, most_taps);
  taps = {taps.begin() + first, taps.begin() + last};
  radii = {radii.begin() + first, radii.begin() + last};
  filter.first_index += static_cast<int>(first);
  return filter;
}

}  // namespace

PrintedSide::PrintedSide(const std::string& filter_name, const Filter<std::string>& printed,
                         std::string sum, const std::optional<std::string>& accuracy)
    : sum_(std::move(sum)), has_stated_accuracy_(accuracy.has_value()) {
  const std::string whose = " of filter " + filter_name;
  if (sum_ != "sqrt2" && sum_ != "1" && sum_ != "2") {
    throw std::invalid_argument(
        must_be("the sum" + whose, std::string_view(sum_), "'sqrt2', '1' or '2'"));
  }
  check_between("the first index" + whose, printed.first_index, -furthest_index, furthest_index);
  Filter<Rational> values{printed.first_index, {}};
  for (const std::string& text : printed.taps) {
    try {
      values.taps.push_back(exact_value(text));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("taps[" + std::to_string(values.taps.size()) + "]" + whose +
                                  ": " + error.what());
    }
    const bool is_zero = values.taps.back().is_zero();
    radii_.push_back(is_zero || accuracy ? Rational(0) : half_unit(text));
  }
  taps_ = trimmed(whose, std::move(values), radii_);
  if (accuracy) *this = with_accuracy(checked_accuracy(*accuracy));
}

PrintedSide PrintedSide::with_accuracy(const Rational& accuracy) const {
  PrintedSide other = *this;
  for (std::size_t i = 0; i < radii_.size(); ++i) {
    other.radii_[i] = taps_.taps[i].is_zero() ? Rational(0) : accuracy;
  }
  return other;
}

Ball PrintedSide::normalising_factor() const {
  if (sum_ == "sqrt2") return Ball(1);
  return sum_ == "1" ? sqrt(Ball(2)) : sqrt(Ball(2)) / Ball(2);
}

Filter<Ball> PrintedSide::enclosures() const {
  Filter<Ball> filter{taps_.first_index, {}};
  const Ball factor = normalising_factor();
  for (std::size_t i = 0; i < radii_.size(); ++i) {
    filter.taps.push_back(Ball::around(taps_.taps[i], radii_[i]) * factor);
  }
  return filter;
}

Filter<Rational> PrintedSide::scaled_to_two() const {
  Filter<Rational> filter = taps_;
  if (sum_ == "1") {
    for (Rational& tap : filter.taps) tap *= Rational(2);
  }
  return filter;
}

std::optional<long> PrintedSide::known_bits() const {
  const Rational largest = std::ranges::max(radii_);
  if (largest.is_zero()) return std::nullopt;
  return static_cast<long>(fmpz_bits(fmpq_denref(largest.get()))) -
         static_cast<long>(fmpz_bits(fmpq_numref(largest.get())));
}

}  // namespace wavecurve::certified
