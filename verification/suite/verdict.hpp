#pragma once

#include <string_view>

namespace wavecurve::verification {

/// What is true of a printed number or of a claim. The order is the order of the report.
enum class Verdict {
  // of a printed number
  certified,         ///< proved: the print is the correctly rounded true value
  form,              ///< the right value, with more or fewer decimals than its column
  misprint,          ///< one edit turns the print into the certified rounding
  published_route,   ///< a named computation yields the printed digits; the true value differs
  agrees_to_digits,  ///< at least three significant digits are right
  discrepant,        ///< fewer than three
  undecided,         ///< the enclosure straddles a rounding boundary at the highest precision tried
  // of a claim
  holds,
  depends_on_definition,  ///< with the figure under each reading
  does_not_hold,
  stand_in,  ///< the source data are lost; shown on other data, named
};

/// "certified", "published-route", "does-not-hold", ...
std::string_view to_string(Verdict verdict);

}  // namespace wavecurve::verification
