#pragma once

#include <optional>
#include <vector>

#include "verification/checker/judged_column.hpp"
#include "verification/routes/table_routes.hpp"

namespace wavecurve::verification {

/// What the search for the computations behind a table's columns came to.
struct FoundRoutes {
  std::vector<ColumnScores> scores;  ///< of each column
  std::vector<std::optional<CreditedRoute>> credits;
  std::vector<CheckedHabit> habits;  ///< that columns are credited to
};

/// The columns in which something is wrong are held against every route, the others only against
/// those that may be a habit of the table.
FoundRoutes find_routes(const std::vector<JudgedColumn>& columns);

}  // namespace wavecurve::verification
