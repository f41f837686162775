#pragma once

#include <string_view>

namespace wavecurve::verification {

/// What is true of a table, figure or statement. The order is the order of the report.
enum class ClaimVerdict {
  // A published table as a whole is one of these; its numbers have a PrintVerdict each.
  certified,        ///< proved: every number is the correctly rounded true value
  form,             ///< every number is right, some with more or fewer decimals than their column
  published_route,  ///< every number is explained, some by the computation that yields its digits
  discrepant,       ///< some number is neither right nor explained
  undecided,        ///< the figures leave it open, or the computation failed
  // A figure or statement is one of these, or undecided as well.
  holds,
  depends_on_definition,  ///< with the figure under each reading
  does_not_hold,
  stand_in,  ///< the source data are lost; shown on other data, named
};

/// "certified", "published-route", "does-not-hold", ... Throws std::invalid_argument for a number
/// that no verdict has.
std::string_view to_string(ClaimVerdict verdict);

/// Whether a verdict of a claim is called so.
bool is_claim_verdict(std::string_view name);

}  // namespace wavecurve::verification
