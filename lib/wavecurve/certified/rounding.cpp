#include "wavecurve/certified/rounding.hpp"

#include <cmath>
#include <stdexcept>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

Rational power_of_ten(long exponent) {
  Rational result(1);
  fmpz* part = exponent < 0 ? fmpq_denref(result.get()) : fmpq_numref(result.get());
  fmpz_set_ui(part, 10);
  fmpz_pow_ui(part, part, static_cast<ulong>(exponent < 0 ? -exponent : exponent));
  return result;
}

std::string integer_text(const fmpz_t n) {
  char* text = fmpz_get_str(nullptr, 10, n);
  std::string result(text);
  flint_free(text);
  return result;
}

std::string integer_text(const Rational& integer) {
  return integer_text(fmpq_numref(integer.get()));
}

/// The nearest integer, ties to even.
Rational nearest_integer(const Rational& x) {
  Rational shifted = x + Rational(1, 2);
  Rational result;
  fmpz* n = fmpq_numref(result.get());
  fmpz_fdiv_q(n, fmpq_numref(shifted.get()), fmpq_denref(shifted.get()));
  const bool tie = fmpz_is_one(fmpq_denref(shifted.get())) != 0;
  if (tie && fmpz_is_odd(n)) fmpz_sub_ui(n, n, 1);
  return result;
}

Rational exact_endpoint(const arf_t x) {
  Rational result;
  arf_get_fmpq(result.get(), x);
  return result;
}

struct Interval {
  Rational lower, upper;
};

/// The ball's exact end points. Throws for a ball without bound.
Interval endpoints(const Ball& x) {
  if (!x.is_finite()) throw std::domain_error("the enclosure is not finite");
  const Rational middle = exact_endpoint(arb_midref(x.get()));
  const Ball radius_ball = x.radius();
  const Rational radius = exact_endpoint(arb_midref(radius_ball.get()));
  return {middle - radius, middle + radius};
}

/// Puts the point into the digits of an integer: ("-1234", 2) -> "-12.34".
std::string with_point(std::string digits, int decimals) {
  const bool negative = digits.starts_with('-');
  if (negative) digits.erase(0, 1);
  const auto places = static_cast<std::size_t>(decimals);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (decimals > 0) digits.insert(digits.size() - places, 1, '.');
  return negative ? "-" + digits : digits;
}

/// floor(log10 |x|) for x other than 0.
long decimal_exponent(const Rational& x) {
  const Rational magnitude = x.abs();
  const double bits = static_cast<double>(fmpz_bits(fmpq_numref(magnitude.get()))) -
                      static_cast<double>(fmpz_bits(fmpq_denref(magnitude.get())));
  long exponent = static_cast<long>(std::floor(bits * std::log10(2.0))) - 1;
  while (magnitude >= power_of_ten(exponent + 1)) ++exponent;
  return exponent;
}

template <class Round>
auto if_both_ends_agree(const Ball& x, Round round) -> std::optional<decltype(round(Rational()))> {
  const auto [lower, upper] = endpoints(x);
  auto from_below = round(lower);
  if (from_below != round(upper)) return std::nullopt;
  return from_below;
}

template <class Real>
std::optional<Real> round_to_binary(const Ball& x, long bits) {
  const auto round = [bits](const arf_t end) {
    arf_t nearest;
    arf_init(nearest);
    arf_set_round(nearest, end, bits, ARF_RND_NEAR);
    const auto result = static_cast<Real>(arf_get_d(nearest, ARF_RND_NEAR));
    arf_clear(nearest);
    return result;
  };
  arf_t lower, upper;
  arf_init(lower);
  arf_init(upper);
  arb_get_lbound_arf(lower, x.get(), ARF_PREC_EXACT);
  arb_get_ubound_arf(upper, x.get(), ARF_PREC_EXACT);
  const Real a = round(lower), b = round(upper);
  arf_clear(lower);
  arf_clear(upper);
  if (a != b) return std::nullopt;
  return a;
}

}  // namespace

std::string round_to_decimals(const Rational& x, int decimals) {
  check_at_least("the number of decimals", decimals, 0);
  return with_point(integer_text(nearest_integer(x * power_of_ten(decimals))), decimals);
}

std::optional<std::string> round_to_decimals(const Ball& x, int decimals) {
  return if_both_ends_agree(x,
                            [&](const Rational& end) { return round_to_decimals(end, decimals); });
}

std::string round_to_digits(const Rational& x, int digits) {
  check_at_least("the number of significant digits", digits, 1);
  if (x.is_zero()) return "0";
  long exponent = decimal_exponent(x);
  std::string mantissa = integer_text(nearest_integer(x * power_of_ten(digits - 1 - exponent)));
  const std::size_t sign = mantissa.starts_with('-') ? 1 : 0;
  if (mantissa.size() - sign > static_cast<std::size_t>(digits)) {  // 9.99 became 10.0
    mantissa.pop_back();
    ++exponent;
  }
  constexpr long smallest_fixed = -5, largest_fixed = 15;
  if (exponent < smallest_fixed || exponent >= largest_fixed) {
    return with_point(mantissa, digits - 1) + "e" + std::to_string(exponent);
  }
  const long decimals = digits - 1 - exponent;
  if (decimals >= 0) return with_point(mantissa, static_cast<int>(decimals));
  return mantissa + std::string(static_cast<std::size_t>(-decimals), '0');
}

std::optional<std::string> round_to_digits(const Ball& x, int digits) {
  return if_both_ends_agree(x, [&](const Rational& end) { return round_to_digits(end, digits); });
}

long bits_for_digits(int digits) {
  constexpr int guard_bits = 40;
  return static_cast<long>(std::ceil(digits * std::log2(10.0))) + guard_bits;
}

std::optional<double> round_to_double(const Ball& x) { return round_to_binary<double>(x, 53); }

std::optional<float> round_to_float(const Ball& x) { return round_to_binary<float>(x, 24); }

std::string magnitude_bound(const Ball& x) {
  const auto [lower, upper] = endpoints(x);
  const Rational bound = lower.abs() < upper.abs() ? upper.abs() : lower.abs();
  if (bound.is_zero()) return "0";
  const long exponent = decimal_exponent(bound);
  const Rational scaled = bound * power_of_ten(-exponent);  // in [1, 10)
  Rational digit;
  fmpz_cdiv_q(fmpq_numref(digit.get()), fmpq_numref(scaled.get()), fmpq_denref(scaled.get()));
  if (digit == Rational(10)) return "1e" + std::to_string(exponent + 1);
  return integer_text(digit) + "e" + std::to_string(exponent);
}

}  // namespace wavecurve::certified
