#pragma once

#include <string_view>

namespace wavecurve::verification {

/// What is true of one printed number. The order is the order of the report.
enum class PrintVerdict {
  certified,         ///< proved: the print is the correctly rounded true value
  form,              ///< the right value in another form than its column's, or filled up with zeros
  misprint,          ///< one edit turns the print into the certified rounding
  published_route,   ///< a named computation yields the printed digits; the true value differs
  agrees_to_digits,  ///< within a unit of the last digit, or three significant digits are right
  discrepant,        ///< neither
  undecided,         ///< the enclosure straddles a rounding boundary at the highest precision tried
};

/// "certified", "published-route", "agrees-to-digits", ... Throws std::invalid_argument for a number
/// that no verdict has.
std::string_view to_string(PrintVerdict verdict);

}  // namespace wavecurve::verification
