#include "verification/tables/print_form.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace wavecurve::verification {

using certified::Ball;

namespace {

/// |value - print| / unit. The print's digits may all agree with the value's, so the difference
/// needs as many bits as they hold (3.33 a digit), and some of its own; a power of two, as in
/// decide().
double distance(const TrueValue& value, const PrintedNumber& print,
                const certified::Rational& unit) {
  long bits = 128;
  while (bits < 4 * static_cast<long>(print.digits.size()) + 64) bits *= 2;
  const certified::WorkingPrecision precision(bits);
  const Ball enclosure = value.exact ? Ball(*value.exact) : value.enclosure(bits);
  return abs((enclosure - Ball(print.value())) / Ball(unit)).to_double();
}

/// With exactly so many digits; zeros in the place of further ones are left out.
PrintedNumber to_scientific(const PrintedNumber& number, int digits) {
  const auto size = static_cast<std::size_t>(digits);
  if (number.is_zero()) return {number.negative, std::string(size, '0'), 1, 0};
  const std::string_view significand = number.significand();
  const int exponent = static_cast<int>(significand.size()) - 1 - number.decimals();
  return {number.negative, std::string(significand.substr(0, size)), 1, exponent};
}

/// The value to as many significant digits, written with a fixed point.
std::optional<PrintedNumber> fixed_with_digits(const TrueValue& value, int digits) {
  if (digits < 1) return std::nullopt;
  const auto rounded = round_to_digits(value, digits);
  if (!rounded || rounded->is_zero() || rounded->decimals() < 0) return std::nullopt;
  return round_to_decimals(value, rounded->decimals());
}

}  // namespace

PrintForm form_of(const PrintedNumber& number) {
  if (number.is_scientific()) return {true, number.significant_digits()};
  return {false, number.decimals()};
}

ColumnForm column_form(const std::vector<PrintedNumber>& prints) {
  std::map<PrintForm, int> counts;
  for (const PrintedNumber& print : prints) {
    if (!print.is_bare_zero()) ++counts[form_of(print)];
  }
  ColumnForm result;
  int most = 0;
  for (const auto& [form, count] : counts) {  // by ascending digits: the last of equals stays
    if (count < most) continue;
    most = count;
    result = {form, count >= 2};
  }
  return result;
}

std::optional<PrintedNumber> round_to_form(const TrueValue& value, const PrintForm& form) {
  if (!form.scientific) return round_to_decimals(value, std::max(form.digits, 0));
  const int digits = std::max(form.digits, 1);
  const auto rounded = round_to_digits(value, digits);
  if (!rounded) return std::nullopt;
  return to_scientific(*rounded, digits);
}

std::vector<PrintedNumber> intended_prints(const TrueValue& value, const PrintedNumber& print,
                                           const ColumnForm& column) {
  const PrintForm own = form_of(print);
  std::vector<PrintForm> forms;
  if (column.established && column.form.scientific == own.scientific) forms.push_back(column.form);
  forms.push_back(own);
  if (!column.established) {
    forms.push_back({own.scientific, own.digits + 1});
    if (own.digits > 1) forms.push_back({own.scientific, own.digits - 1});
  }
  std::vector<PrintedNumber> result;
  for (const PrintForm& form : forms) {
    if (const auto rounded = round_to_form(value, form)) result.push_back(*rounded);
  }
  if (!own.scientific) {
    const auto rounded = fixed_with_digits(value, print.significant_digits());
    if (rounded) result.push_back(*rounded);
  }
  return result;
}

int correct_digits(const TrueValue& value, const PrintedNumber& print) {
  constexpr int enough = 20;  // to know the leading digit's place
  const auto rounded = round_to_digits(value, enough);
  if (!rounded || rounded->is_zero() || print.is_zero()) return 0;
  const int first_place = static_cast<int>(rounded->significand().size()) - rounded->decimals() - 1;
  const double error = distance(value, print, power_of_ten(first_place));
  const int printed_digits = print.significant_digits();
  if (error == 0) return printed_digits;
  // The largest k with error < 10^(1 - k).
  return std::clamp(static_cast<int>(std::ceil(-std::log10(error))), 0, printed_digits);
}

double distance_in_units(const TrueValue& value, const PrintedNumber& print) {
  return distance(value, print, print.unit());
}

int first_wrong_digit(const PrintedNumber& print, const PrintedNumber& right) {
  const std::string a = print.mantissa(), b = right.mantissa();
  if (print.negative != right.negative || print.exponent != right.exponent ||
      a.size() != b.size()) {
    return 1;
  }
  int place = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool is_digit = b[i] >= '0' && b[i] <= '9';
    if (is_digit && (place > 0 || b[i] != '0' || a[i] != '0')) ++place;
    if (a[i] != b[i]) return std::max(place, 1);
  }
  return 0;
}

}  // namespace wavecurve::verification
