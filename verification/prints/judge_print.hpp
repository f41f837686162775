#pragma once

#include <optional>
#include <string>

#include "verification/prints/misprint.hpp"
#include "verification/prints/print_form.hpp"
#include "verification/prints/print_verdict.hpp"
#include "verification/prints/true_value.hpp"

namespace wavecurve::verification {

// What is said of one print that is held against the true value. check_table.hpp tells when which
// verdict is given.

struct JudgedPrint {
  PrintVerdict verdict = PrintVerdict::undecided;
  std::string detail;
  bool wrong = false;            ///< proved not to be the rounded value; the verdict is then open
  std::optional<Repair> repair;  ///< of a wrong one: the edit that leads to the right number
  /// The right number in its column's form, where only this equals the print.
  std::optional<PrintedNumber> in_column_form = {};
};

/// certified, form or undecided; else wrong.
JudgedPrint judge_print(const TrueValue& value, const PrintedNumber& print,
                        const ColumnForm& column);

/// The verdict of a wrong print that no route yields: agrees-to-digits, if it is a neighbour of the
/// right one; form, if only zeros that fill it up are wrong and its column is otherwise accurate (in
/// an inaccurate one some last digits are zeros by chance); misprint, with the repair or, but for its
/// sign, within a unit; else agrees-to-digits or discrepant.
JudgedPrint judge_wrong_print(const TrueValue& value, const PrintedNumber& print,
                              const std::optional<Repair>& repair, bool column_is_accurate = true);

/// "the true value differs from significant digit 8 on"
std::string describe_difference(const Departure& departure, const PrintedNumber& print);

/// The value as a report shows it beside the print, correctly rounded: with the digits of the
/// column, or of the print where that has more and is wrong. Beside a fraction an exactly known
/// value is a fraction.
std::string certified_text(const TrueValue& value, const PrintedNumber& print,
                           const ColumnForm& column, bool wrong);

}  // namespace wavecurve::verification
