#pragma once

#include <optional>
#include <vector>

#include "verification/prints/printed_number.hpp"
#include "verification/prints/true_value.hpp"

namespace wavecurve::verification {

/// How the numbers of a column are printed: fixed with so many decimals, or scientific with so many
/// significant digits.
struct PrintForm {
  bool scientific = false;
  int digits = 0;

  auto operator<=>(const PrintForm&) const = default;
};

struct ColumnForm {
  PrintForm form;  ///< the most common one
  /// The habit of each notation: the form that more than half of its prints have, two at least; a
  /// print in another form is then the odd one. A column that mixes both notations has two habits,
  /// one of numbers with so many significant digits and a fixed point has none.
  std::optional<PrintForm> fixed, scientific;

  /// The habit of the print's notation; nothing for a fraction.
  std::optional<PrintForm> habit(const PrintedNumber& print) const;
};

PrintForm form_of(const PrintedNumber& number);

/// The most common form; if several are as common, the one with the most digits. A bare 0 and a
/// fraction have no say; a column of nothing else has no form.
ColumnForm column_form(const std::vector<PrintedNumber>& prints);

/// The value correctly rounded in this form; nothing if that is undecided at the precision limit.
std::optional<PrintedNumber> round_to_form(const TrueValue& value, const PrintForm& form);

/// What the print may have been meant to be, for the search for a misprint: the roundings in the
/// column's form, in the print's own, and to as many significant digits as the print has; in a
/// column without a habit also with one digit more or fewer. Scientific ones have their point where
/// the print has it. None for a fraction.
std::vector<PrintedNumber> intended_prints(const TrueValue& value, const PrintedNumber& print,
                                           const ColumnForm& column);

/// How many leading significant digits of the print are right: the largest k for which the print is
/// less than one unit of the value's k-th significant digit away, so that digits which agree as
/// text always count, and 0.3999 has three right digits of 0.4001; 0 if the value is zero. A
/// fraction may have as many right digits as stand above and below its line.
int correct_digits(const TrueValue& value, const PrintedNumber& print);

/// |print - value| in units of the print's last digit; not a number for a fraction, which has none.
double distance_in_units(const TrueValue& value, const PrintedNumber& print);

/// A wrong print without zeros at its end that only fill it up to the length of others, where it is a
/// correct rounding without them and has at least three significant digits left: 0.59619180 for
/// 0.5961918029... is 0.5961918. As few zeros as possible leave. Nothing if there is no such number.
std::optional<PrintedNumber> without_padding(const TrueValue& value, const PrintedNumber& print);

/// Where a print departs from the right number.
struct Departure {
  bool sign = false;  ///< one has a minus, the other has not
  /// The first digit that differs, place by place, as an index into PrintedNumber::digits; the first
  /// of all if the right number has more places before the point. Nothing if none differs.
  std::optional<std::size_t> digit;
  /// One past the last digit that is wrong, where those behind it are known to be right; else 0.
  std::size_t end = 0;

  bool operator==(const Departure&) const = default;
};

/// Compares what stands in the places of the print, whatever the notations. A fraction that is not the
/// right number departs from its first digit on.
Departure departure(const PrintedNumber& print, const PrintedNumber& right);

/// From the value rounded to the print's own last digit. A wrong print that equals it (a bare 0 for
/// 0.3), or whose rounding is undecided, departs from its first digit on.
Departure departure(const TrueValue& value, const PrintedNumber& print);

}  // namespace wavecurve::verification
