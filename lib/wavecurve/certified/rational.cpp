#include "wavecurve/certified/rational.hpp"

#include <charconv>
#include <stdexcept>

namespace wavecurve::certified {

namespace {

constexpr int largest_decimal_exponent = 10000;  // keeps "1e999999999" from filling the memory

[[noreturn]] void refuse(std::string_view text) {
  constexpr std::size_t shown = 60;
  throw std::invalid_argument("'" + std::string(text.substr(0, shown)) +
                              (text.size() > shown ? "...'" : "'") + " is not a decimal number");
}

}  // namespace

Rational::Rational(long numerator, long denominator) : Rational(numerator) {
  *this /= Rational(denominator);
}

Rational Rational::from_decimal(std::string_view decimal) {
  std::string_view rest = decimal;
  std::string digits;
  if (rest.starts_with('-')) digits = "-";
  if (rest.starts_with('-') || rest.starts_with('+')) rest.remove_prefix(1);
  long exponent = 0;
  bool seen_digit = false, seen_point = false;
  while (!rest.empty() && rest.front() != 'e' && rest.front() != 'E') {
    const char c = rest.front();
    if (c == '.' && !seen_point) {
      seen_point = true;
    } else if (c >= '0' && c <= '9') {
      digits += c;
      seen_digit = true;
      if (seen_point) --exponent;
    } else {
      refuse(decimal);
    }
    rest.remove_prefix(1);
  }
  if (!seen_digit) refuse(decimal);
  if (!rest.empty()) {
    rest.remove_prefix(1);
    if (rest.starts_with("+-")) refuse(decimal);
    if (rest.starts_with('+')) rest.remove_prefix(1);
    long printed = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), printed);
    if (error != std::errc() || end != rest.data() + rest.size()) refuse(decimal);
    if (printed > largest_decimal_exponent || printed < -largest_decimal_exponent) refuse(decimal);
    exponent += printed;
  }
  Rational result, scale;
  fmpz_set_str(fmpq_numref(result.value_), digits.c_str(), 10);
  fmpz_set_ui(fmpq_numref(scale.value_), 10);
  fmpz_pow_ui(fmpq_numref(scale.value_), fmpq_numref(scale.value_),
              static_cast<ulong>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? result / scale : result * scale;
}

Rational Rational::power_of_two(long exponent) {
  Rational result;
  fmpz* part = exponent < 0 ? fmpq_denref(result.value_) : fmpq_numref(result.value_);
  fmpz_one(fmpq_numref(result.value_));
  fmpz_one_2exp(part, static_cast<ulong>(exponent < 0 ? -exponent : exponent));
  return result;
}

Rational Rational::binomial(unsigned long n, unsigned long k) {
  Rational result;
  fmpz_bin_uiui(fmpq_numref(result.value_), n, k);
  return result;
}

Rational Rational::factorial(unsigned long n) {
  Rational result;
  fmpz_fac_ui(fmpq_numref(result.value_), n);
  return result;
}

Rational& Rational::operator/=(const Rational& b) {
  if (b.is_zero()) throw std::domain_error("division of a rational number by zero");
  fmpq_div(value_, value_, b.value_);
  return *this;
}

std::string Rational::to_string() const {
  char* text = fmpq_get_str(nullptr, 10, value_);
  std::string result(text);
  flint_free(text);
  return result;
}

}  // namespace wavecurve::certified
