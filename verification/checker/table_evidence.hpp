#pragma once

#include <string>

#include "verification/checker/check_table.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification {

// What the claims about published tables show.

/// Every row: print, certified value, distance, verdict, detail.
Table row_table(const CheckedTable& table);

/// Every column with its route, and the chance of that.
Table column_table(const CheckedTable& table);

/// The routes tried for a column whose names start with `start`, those that come nearest first, at
/// most `most` of them.
Table route_table(const CheckedColumn& column, const std::string& start, std::size_t most);

/// |print - true value| of every entry that is not exactly right, on a logarithmic scale.
Chart deviation_chart(const CheckedTable& table, const std::string& id);

/// What the verdicts of its numbers make of the table. Misprints alone, without a route, leave it
/// discrepant.
ClaimVerdict verdict_of(const CheckedTable& table);

/// How many numbers have each verdict: "16 certified, 2 form".
Finding count_finding(const CheckedTable& table);

}  // namespace wavecurve::verification
