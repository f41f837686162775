#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/routes/column_routes.hpp"

namespace wavecurve::verification {

/// The route that a column is credited to.
struct CreditedRoute {
  std::size_t route = 0;  ///< in the column's scores
  /// The probability that among all computations tried an unrelated one of the same accuracy does
  /// as well: for this column alone or, if that is less, for all columns of the habit.
  double chance = 1;
  std::string habit;        ///< that is shared, empty if the column stands for itself
  std::size_t columns = 1;  ///< that the chance is for
};

/// What columns of a table have in common.
struct TableHabit {
  std::string name;
  std::vector<std::size_t> explained;    ///< columns
  std::vector<std::size_t> unexplained;  ///< columns that could have come by it, and did not
  double chance = 1;
};

/// The scores of a column, the true values first.
using ColumnScores = std::vector<RouteScore>;

/// Habits that explain a column in which something is wrong, better than the true values do.
std::vector<std::string> likely_habits(const std::vector<ColumnScores>& columns);

/// The habits that chance does not explain (route_chance.hpp). One that explains c of the C columns
/// in which it was tried has, for each of the c, the chance of its best route there times the
/// number of routes tried that have the habit; their product times the number of ways to choose c
/// of C columns, times C, times the number of habits.
std::vector<TableHabit> find_habits(const std::vector<ColumnScores>& columns);

/// For each column the credited route, if there is one: of those that explain it, yield a wrong
/// entry and more entries than the true values do, and whose chance is below credible_chance, the
/// one that yields most, the first of equals. A column's own chance is multiplied by the number of
/// computations tried for it.
std::vector<std::optional<CreditedRoute>> credit_routes(const std::vector<ColumnScores>& columns,
                                                        const std::vector<TableHabit>& habits);

}  // namespace wavecurve::verification
