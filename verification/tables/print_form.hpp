#pragma once

#include <optional>
#include <vector>

#include "verification/tables/printed_number.hpp"
#include "verification/tables/true_value.hpp"

namespace wavecurve::verification {

/// How the numbers of a column are printed: fixed with so many decimals, or scientific with so many
/// significant digits.
struct PrintForm {
  bool scientific = false;
  int digits = 0;

  auto operator<=>(const PrintForm&) const = default;
};

struct ColumnForm {
  PrintForm form;
  /// At least two prints have it: a print that differs is then the odd one.
  bool established = false;
};

PrintForm form_of(const PrintedNumber& number);

/// The most common form; if several are as common, the one with the most digits. A bare 0 has no
/// say; a column of nothing else has no form.
ColumnForm column_form(const std::vector<PrintedNumber>& prints);

/// The value correctly rounded in this form; nothing if that is undecided at the precision limit.
std::optional<PrintedNumber> round_to_form(const TrueValue& value, const PrintForm& form);

/// What the print may have been meant to be, for the search for a misprint: the roundings in the
/// column's form, in the print's own, and to as many significant digits as the print has; in a
/// column without established form also with one digit more or fewer.
std::vector<PrintedNumber> intended_prints(const TrueValue& value, const PrintedNumber& print,
                                           const ColumnForm& column);

/// How many leading significant digits of the print are right: the largest k for which the print is
/// less than one unit of the value's k-th significant digit away, so that digits which agree as
/// text always count, and 0.3999 has three right digits of 0.4001; 0 if the value is zero.
int correct_digits(const TrueValue& value, const PrintedNumber& print);

/// |print - value| in units of the print's last digit.
double distance_in_units(const TrueValue& value, const PrintedNumber& print);

/// The first significant digit, counted from 1, in which a print differs from the right number
/// printed alike; 0 if none does.
int first_wrong_digit(const PrintedNumber& print, const PrintedNumber& right);

}  // namespace wavecurve::verification
