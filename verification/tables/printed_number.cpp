#include "verification/tables/printed_number.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "wavecurve/certified/ball.hpp"

namespace wavecurve::verification {

namespace {

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
  throw std::invalid_argument(excerpt(text) + " " + why);
}

/// Takes a sign off the front; true for a minus.
bool take_sign(std::string_view& rest) {
  constexpr std::string_view typeset_minus = "\xE2\x88\x92";
  if (rest.starts_with(typeset_minus)) {
    rest.remove_prefix(typeset_minus.size());
    return true;
  }
  const bool negative = rest.starts_with('-');
  if (negative || rest.starts_with('+')) rest.remove_prefix(1);
  return negative;
}

std::string take_digits(std::string_view& rest) {
  const auto end = std::find_if_not(rest.begin(), rest.end(), is_digit);
  std::string digits(rest.begin(), end);
  rest.remove_prefix(digits.size());
  return digits;
}

int parse_exponent(std::string_view rest, std::string_view text) {
  const bool negative = take_sign(rest);
  int magnitude = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), magnitude);
  const bool whole = !rest.empty() && is_digit(rest.front()) && end == rest.data() + rest.size();
  if (!whole) refuse(text, "is not a decimal number");
  if (error != std::errc() || magnitude > largest_printed_exponent) {
    refuse(text, "has an exponent beyond " + std::to_string(largest_printed_exponent));
  }
  return negative ? -magnitude : magnitude;
}

}  // namespace

std::string excerpt(std::string_view text) {
  constexpr std::size_t shown = 40;
  std::string result(text.substr(0, shown));
  for (char& c : result) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + result + (text.size() > shown ? "...'" : "'");
}

int PrintedNumber::decimals() const {
  return static_cast<int>(digits.size()) - integer_digits - exponent.value_or(0);
}

std::string_view PrintedNumber::significand() const {
  const auto first = digits.find_first_not_of('0');
  if (first == std::string::npos) return {};
  return std::string_view(digits).substr(first);
}

int PrintedNumber::significant_digits() const {
  if (is_zero()) return static_cast<int>(digits.size());
  return static_cast<int>(significand().size());
}

std::string PrintedNumber::mantissa() const {
  const auto before = static_cast<std::size_t>(integer_digits);
  if (digits.size() == before) return digits;
  return digits.substr(0, before) + "." + digits.substr(before);
}

std::string PrintedNumber::text() const {
  std::string result = (negative ? "-" : "") + mantissa();
  if (exponent) result += "e" + std::to_string(*exponent);
  return result;
}

certified::Rational PrintedNumber::value() const {
  return certified::Rational::from_decimal(text());
}

certified::Rational PrintedNumber::unit() const { return power_of_ten(-decimals()); }

double PrintedNumber::to_double() const {
  constexpr long more_than_a_double = 128;
  const certified::WorkingPrecision precision(more_than_a_double);
  return certified::Ball(value()).to_double();
}

PrintedNumber parse_printed_number(std::string_view text) {
  std::string_view rest = text;
  PrintedNumber number;
  number.negative = take_sign(rest);
  const std::string before = take_digits(rest);
  std::string behind;
  if (rest.starts_with('.')) {
    rest.remove_prefix(1);
    behind = take_digits(rest);
  }
  if (before.empty() && behind.empty()) refuse(text, "is not a decimal number");
  number.digits = (before.empty() ? "0" : before) + behind;
  number.integer_digits = before.empty() ? 1 : static_cast<int>(before.size());
  if (number.digits.size() > most_printed_digits) {
    refuse(text, "has more than " + std::to_string(most_printed_digits) + " digits");
  }
  if (rest.empty()) return number;
  if (rest.front() != 'e' && rest.front() != 'E') refuse(text, "is not a decimal number");
  number.exponent = parse_exponent(rest.substr(1), text);
  return number;
}

certified::Rational power_of_ten(int exponent) {
  return certified::Rational::from_decimal("1e" + std::to_string(exponent));
}

}  // namespace wavecurve::verification
