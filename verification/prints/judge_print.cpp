#include "verification/prints/judge_print.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/certified/decimal_enclosure.hpp"
#include "wavecurve/certified/rounding.hpp"

namespace wavecurve::verification {

namespace {

constexpr int least_correct_digits = 3;

std::string counted(int count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string digits_text(const PrintForm& form) {
  return counted(form.digits, form.scientific ? "significant digit" : "decimal");
}

bool is_proved_negative(const TrueValue& value) {
  const auto is_negative = [](const certified::Ball& enclosure) {
    if (certainly_less(enclosure, certified::Ball(0))) return Decision::yes;
    return enclosure.contains_zero() && !enclosure.is_exact() ? Decision::undecided : Decision::no;
  };
  return decide(value, is_negative) == Decision::yes;
}

bool is_tie(const TrueValue& value, const PrintedNumber& print) {
  return value.exact && !print.is_fraction() &&
         (*value.exact - print.value()).abs() == print.unit() / certified::Rational(2);
}

std::string other_form_text(const PrintedNumber& print, const PrintForm& habit) {
  return fmt::format("the right value with {}; its column has {}", digits_text(form_of(print)),
                     digits_text(habit));
}

JudgedPrint verdict_of_right(const TrueValue& value, const PrintedNumber& print,
                             const std::optional<PrintForm>& habit) {
  if (print.is_bare_zero() && value.is_exactly_zero()) {
    return {PrintVerdict::certified, "exactly zero", false, {}};
  }
  if (print.is_fraction()) return {PrintVerdict::certified, "exactly this fraction", false, {}};
  if (habit && form_of(print) != *habit) {
    return {PrintVerdict::form, other_form_text(print, *habit), false, {}};
  }
  if (print.is_zero() && print.negative && !is_proved_negative(value)) {
    return {PrintVerdict::form, "the right value with a sign that it does not have", false, {}};
  }
  return {PrintVerdict::certified,
          is_tie(value, print) ? "an exact tie; either neighbour is a correct rounding" : "",
          false,
          {}};
}

/// The print is no correct rounding at its own last digit; it may still be the number that the
/// column's form asks for, with zeros behind it.
std::optional<PrintedNumber> right_number(const TrueValue& value, const PrintedNumber& print,
                                          const std::optional<PrintForm>& habit) {
  if (!habit) return std::nullopt;
  auto rounded = round_to_form(value, *habit);
  const bool is_equal = rounded && rounded->value() == print.value();
  return is_equal ? rounded : std::nullopt;
}

std::string padding_text(const PrintedNumber& print, const PrintedNumber& shorter) {
  const auto zeros = static_cast<int>(print.digits.size() - shorter.digits.size());
  return fmt::format("right to {} ({}), then filled up with {}", digits_text(form_of(shorter)),
                     shorter.text(), counted(zeros, "zero"));
}

std::string misprint_text(const Repair& repair) {
  const std::string text = repair.description + ": " + repair.repaired.text();
  if (!repair.only_last_digit) return text;
  return text + "; only the last digit, so an inaccurate computation explains it as well";
}

/// "2 of 12 significant digits right"
std::string right_digits_text(int correct, const PrintedNumber& print) {
  if (print.is_fraction()) {
    return counted(correct, "significant digit") +
           " right; a fraction is the value itself or is not";
  }
  return fmt::format("{} of {} right", correct,
                     counted(print.significant_digits(), "significant digit"));
}

PrintedNumber with_other_sign(PrintedNumber print) {
  print.negative = !print.negative;
  return print;
}

/// Less than one unit of the last digit off. A bare zero and a fraction have no such digit.
bool is_within_a_unit(const TrueValue& value, const PrintedNumber& print) {
  if (print.is_fraction() || print.is_bare_zero()) return false;
  if (value.exact) return (*value.exact - print.value()).abs() < print.unit();
  return is_within(value, print.value(), print.unit()) == Decision::yes;
}

JudgedPrint agreeing(const PrintedNumber& print, int correct, const std::string& why) {
  return {PrintVerdict::agrees_to_digits, right_digits_text(correct, print) + why, true, {}};
}

/// Read as a double, the print is the one nearest the value: as programs print doubles, in the fewest
/// digits that give them back.
bool is_nearest_double(const TrueValue& value, const PrintedNumber& print) {
  constexpr int fewest = 15, most = 17;  // that distinguish doubles
  const int digits = print.significant_digits();
  if (digits < fewest || digits > most) return false;
  return decide(value, [&](const certified::Ball& enclosure) {
           const auto nearest = certified::round_to_double(enclosure);
           if (!nearest) return Decision::undecided;
           return *nearest == print.to_double() ? Decision::yes : Decision::no;
         }) == Decision::yes;
}

/// Why a print that is less than a unit off is what it is, as far as that can be proved.
std::string near_text(const TrueValue& value, const PrintedNumber& print) {
  if (is_nearest_double(value, print))
    return "; read as a double it is the nearest to the true value";
  if (is_cut_off(value, print.value(), print.decimals()) == Decision::yes) {
    return "; the true value cut off instead of rounded";
  }
  return "; off by less than one unit of its last digit";
}

/// A print that is as far off as another rounding of the same value would be.
std::optional<JudgedPrint> judge_nearly_right(const TrueValue& value, const PrintedNumber& print,
                                              int correct) {
  if (is_within_a_unit(value, print)) {
    return agreeing(print, correct, near_text(value, print));
  }
  constexpr double neighbour_of_the_rounding = 1.5;
  if (correct >= least_correct_digits &&
      distance_in_units(value, print) <= neighbour_of_the_rounding) {
    return agreeing(print, correct, "; one unit in the last digit is a rounding difference");
  }
  return std::nullopt;
}

/// What only the sign keeps from being right, or as good as right, the verdict is the same.
std::optional<JudgedPrint> judge_wrong_sign(const TrueValue& value, const PrintedNumber& print) {
  const PrintedNumber turned = with_other_sign(print);
  const int correct = correct_digits(value, turned);
  if (correct < least_correct_digits) return std::nullopt;
  const bool is_misprint = is_within_a_unit(value, turned);
  return JudgedPrint{is_misprint ? PrintVerdict::misprint : PrintVerdict::discrepant,
                     std::string(print.negative ? "an added sign" : "a lost sign") +
                         "; but for it, " + right_digits_text(correct, print),
                     true,
                     {}};
}

}  // namespace

JudgedPrint judge_print(const TrueValue& value, const PrintedNumber& print,
                        const ColumnForm& column) {
  const std::optional<PrintForm> habit = column.habit(print);
  // The unit of a fraction is zero: it is right if it is equal.
  switch (is_within(value, print.value(), print.unit() / certified::Rational(2))) {
    case Decision::yes:
      return verdict_of_right(value, print, habit);
    case Decision::undecided:
      return {PrintVerdict::undecided,
              fmt::format("the {} is still open at {} bits",
                          print.is_fraction() ? "equality" : "rounding", precision_limit_bits),
              false,
              {}};
    case Decision::no:
      break;
  }
  if (auto right = right_number(value, print, habit)) {
    return {PrintVerdict::form, other_form_text(print, *habit), false, {}, std::move(right)};
  }
  JudgedPrint wrong;
  wrong.wrong = true;
  wrong.repair = likeliest_repair(print, intended_prints(value, print, column));
  return wrong;
}

JudgedPrint judge_wrong_print(const TrueValue& value, const PrintedNumber& print,
                              const std::optional<Repair>& repair, bool column_is_accurate) {
  const int correct = correct_digits(value, print);
  if (const auto judged = judge_nearly_right(value, print, correct)) return *judged;
  const auto shorter = column_is_accurate ? without_padding(value, print) : std::nullopt;
  if (shorter) {
    return {PrintVerdict::form, padding_text(print, *shorter), true, {}};
  }
  if (repair) return {PrintVerdict::misprint, misprint_text(*repair), true, repair};
  if (const auto judged = judge_wrong_sign(value, print)) return *judged;
  if (correct >= least_correct_digits) return agreeing(print, correct, "");
  return {PrintVerdict::discrepant,
          value.is_exactly_zero() ? "the true value is exactly zero"
                                  : right_digits_text(correct, print),
          true,
          {}};
}

std::string describe_difference(const Departure& departure, const PrintedNumber& print) {
  const std::size_t zeros = print.digits.size() - print.significand().size();
  const std::size_t digit = departure.sign ? 0 : departure.digit.value_or(0);
  return fmt::format("the true value differs from significant digit {} on",
                     digit > zeros ? digit - zeros + 1 : 1);
}

std::string certified_text(const TrueValue& value, const PrintedNumber& print,
                           const ColumnForm& column, bool wrong) {
  if (print.is_fraction() && value.exact) return value.exact->to_string();
  const PrintForm own = form_of(print);
  PrintForm shown = column.habit(print).value_or(print.is_fraction() ? column.form : own);
  if (wrong && own.scientific == shown.scientific) {
    shown.digits = std::max(shown.digits, own.digits);
  }
  const auto rounded = round_to_form(value, shown);
  if (rounded) return rounded->text();
  constexpr int most_digits = 15;
  return value.exact
             ? certified::round_to_digits(*value.exact, most_digits)
             : certified::supported_decimal(value.enclosure(precision_limit_bits), most_digits)
                   .value;
}

}  // namespace wavecurve::verification
