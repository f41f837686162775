#include "verification/prints/print_form.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include <fmt/format.h>

#include "wavecurve/elementary/logarithm.hpp"

namespace wavecurve::verification {

using certified::Ball;

namespace {

/// |value - print| / unit. The print's digits may all agree with the value's, so the difference
/// needs as many bits as they hold (3.33 a digit), and some of its own; a power of two, as in
/// decide().
double distance(const TrueValue& value, const PrintedNumber& print,
                const certified::Rational& unit) {
  const auto digits = static_cast<long>(print.digits.size() + print.denominator.size());
  long bits = 128;
  while (bits < 4 * digits + 64) bits *= 2;
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

/// The same number with as many digits before its point as the print has, not counting zeros: of
/// 4.1e-3 and a print 0.72e-2 it makes 0.41e-2.
PrintedNumber laid_out_as(const PrintedNumber& print, const PrintedNumber& number) {
  if (!print.is_scientific() || print.is_zero() || number.is_zero()) return number;
  const int zeros = static_cast<int>(print.digits.find_first_not_of('0'));
  // A single digit before the point is what to_scientific gives.
  const int shift = 1 - (print.integer_digits - zeros);
  PrintedNumber result{number.negative,
                       std::string(static_cast<std::size_t>(zeros), '0').append(number.digits),
                       print.integer_digits, *number.exponent + shift};
  if (result.digits.size() < static_cast<std::size_t>(result.integer_digits)) return number;
  return result;
}

/// The form that more than half of the prints of a notation have.
std::optional<PrintForm> habit_of(const std::map<PrintForm, int>& counts, bool scientific) {
  std::optional<PrintForm> habit;
  int most = 1, all = 0;
  for (const auto& [form, count] : counts) {
    if (form.scientific != scientific) continue;
    all += count;
    if (count <= most) continue;
    most = count;
    habit = form;
  }
  return 2 * most > all ? habit : std::nullopt;
}

/// The value to as many significant digits, written with a fixed point.
std::optional<PrintedNumber> fixed_with_digits(const TrueValue& value, int digits) {
  if (digits < 1) return std::nullopt;
  const auto rounded = round_to_digits(value, digits);
  if (!rounded || rounded->is_zero() || rounded->decimals() < 0) return std::nullopt;
  return round_to_decimals(value, rounded->decimals());
}

/// The power of ten of the first significant digit; nothing for zero. Sixteen digits, or twenty, tell
/// it; what rounds up to the next power of ten counts as that.
std::optional<int> place_of_first_digit(const TrueValue& value) {
  const double magnitude = std::abs(value.to_double());
  constexpr double normal = std::numeric_limits<double>::min();
  if (magnitude >= normal && std::isfinite(magnitude)) {
    const std::string text = fmt::format("{:.15e}", magnitude);
    return std::stoi(text.substr(text.find('e') + 1));
  }
  constexpr int enough = 20;
  const auto rounded = round_to_digits(value, enough);
  if (!rounded || rounded->is_zero()) return std::nullopt;
  return static_cast<int>(rounded->significand().size()) - rounded->decimals() - 1;
}

}  // namespace

PrintForm form_of(const PrintedNumber& number) {
  if (number.is_scientific()) return {true, number.significant_digits()};
  return {false, number.decimals()};
}

std::optional<PrintForm> ColumnForm::habit(const PrintedNumber& print) const {
  if (print.is_fraction()) return std::nullopt;
  return print.is_scientific() ? scientific : fixed;
}

ColumnForm column_form(const std::vector<PrintedNumber>& prints) {
  std::map<PrintForm, int> counts;
  std::map<int, int> with_digits;  // fixed prints by their significant digits
  for (const PrintedNumber& print : prints) {
    if (print.is_bare_zero() || print.is_fraction()) continue;
    ++counts[form_of(print)];
    if (!print.is_scientific()) ++with_digits[print.significant_digits()];
  }
  ColumnForm result;
  int most = 0;
  for (const auto& [form, count] : counts) {  // by ascending digits: the last of equals stays
    if (count < most) continue;
    most = count;
    result.form = form;
  }
  const auto most_common = [](const auto& counted) {
    int largest = 0;
    for (const auto& [key, count] : counted) largest = std::max(largest, count);
    return largest;
  };
  result.fixed = habit_of(counts, false);
  result.scientific = habit_of(counts, true);
  if (result.fixed && most_common(with_digits) > counts[*result.fixed]) result.fixed.reset();
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
  if (print.is_fraction()) return {};
  const PrintForm own = form_of(print);
  const std::optional<PrintForm> habit = column.habit(print);
  std::vector<PrintForm> forms;
  if (habit) forms.push_back(*habit);
  forms.push_back(own);
  if (!habit) {
    forms.push_back({own.scientific, own.digits + 1});
    if (own.digits > 1) forms.push_back({own.scientific, own.digits - 1});
  }
  std::vector<PrintedNumber> result;
  for (const PrintForm& form : forms) {
    if (const auto rounded = round_to_form(value, form)) {
      result.push_back(laid_out_as(print, *rounded));
    }
  }
  if (!own.scientific) {
    const auto rounded = fixed_with_digits(value, print.significant_digits());
    if (rounded) result.push_back(*rounded);
  }
  return result;
}

int correct_digits(const TrueValue& value, const PrintedNumber& print) {
  if (print.is_zero()) return 0;
  const std::optional<int> place = place_of_first_digit(value);
  if (!place) return 0;
  const double error = distance(value, print, power_of_ten(*place));
  const int printed_digits = print.is_fraction()
                                 ? static_cast<int>(print.digits.size() + print.denominator.size())
                                 : print.significant_digits();
  if (error == 0) return printed_digits;
  // The largest k with error < 10^(1 - k).
  return std::clamp(static_cast<int>(std::ceil(-logarithm_10(error))), 0, printed_digits);
}

double distance_in_units(const TrueValue& value, const PrintedNumber& print) {
  if (print.is_fraction()) return std::numeric_limits<double>::quiet_NaN();
  return distance(value, print, print.unit());
}

std::optional<PrintedNumber> without_padding(const TrueValue& value, const PrintedNumber& print) {
  if (print.is_fraction() || print.is_zero()) return std::nullopt;
  constexpr int least_digits = 3;
  PrintedNumber shorter = print;
  while (shorter.digits.back() == '0' &&
         shorter.digits.size() > static_cast<std::size_t>(shorter.integer_digits)) {
    shorter.digits.pop_back();
    if (shorter.significant_digits() < least_digits) return std::nullopt;
    const certified::Rational half = shorter.unit() / certified::Rational(2);
    if (is_within(value, shorter.value(), half) == Decision::yes) return shorter;
  }
  return std::nullopt;
}

Departure departure(const PrintedNumber& print, const PrintedNumber& right) {
  if (print.is_fraction()) return {false, 0, 0};
  std::string printed = print.digits, true_digits = right.digits;
  const int missing = print.decimals() - right.decimals();
  const auto size = static_cast<int>(true_digits.size());
  true_digits.resize(static_cast<std::size_t>(std::max(size + missing, 0)), '0');
  const std::size_t width = std::max(printed.size(), true_digits.size());
  const std::size_t added = width - printed.size();
  printed.insert(0, added, '0');
  true_digits.insert(0, width - true_digits.size(), '0');
  Departure result{print.negative != right.negative && !right.is_zero(), std::nullopt};
  const auto differing = std::mismatch(printed.begin(), printed.end(), true_digits.begin()).first;
  if (differing == printed.end()) return result;
  const auto place = static_cast<std::size_t>(differing - printed.begin());
  result.digit = place < added ? 0 : place - added;
  return result;
}

Departure departure(const TrueValue& value, const PrintedNumber& print) {
  constexpr Departure from_the_first{false, 0, 0};
  if (print.is_fraction()) return from_the_first;
  const auto right = print.decimals() >= 0 ? round_to_decimals(value, print.decimals())
                                           : round_to_digits(value, print.significant_digits());
  if (!right) return from_the_first;
  const Departure found = departure(print, *right);
  return found.sign || found.digit ? found : from_the_first;
}

}  // namespace wavecurve::verification
