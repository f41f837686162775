#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/tables/print_form.hpp"
#include "verification/tables/routes.hpp"

namespace wavecurve::verification {

/// An entry of a column as the search for its route sees it.
struct EntryToExplain {
  std::size_t place = 0;  ///< in RouteValues::values
  PrintedNumber print;
  std::optional<PrintedNumber> repaired;  ///< the right number, if one edit leads there
  bool wrong = false;                     ///< proved not to be the rounded true value
  double true_value = 0;
};

struct ColumnToExplain {
  Quantity quantity;
  PrintForm form;
  std::vector<EntryToExplain> entries;
};

/// How well a route explains a column.
struct RouteScore {
  std::string name;
  int matched = 0;      ///< entries whose digits it yields, up to the edit of a misprint
  int after_edit = 0;   ///< of these, the ones that need the edit
  int own = 0;          ///< wrong entries that it yields as they are printed
  double farthest = 0;  ///< largest distance from a print (edited where needed), in its last unit
  std::vector<bool> yields_print;  ///< for each entry, without an edit
};

/// A route credited with fewer wrong entries could be an accident of rounding.
inline constexpr int least_entries_of_a_route = 2;

/// The scores of every route, the simplest first: the true values rounded, the true values cut off,
/// then those of run_routes. Only the first, if nothing in the column is wrong.
std::vector<RouteScore> score_routes(const ColumnToExplain& column, const RouteInput& input);

/// The route that yields most entries, the first of equals; other than the true values it has to
/// yield at least least_entries_of_a_route wrong ones.
const RouteScore& best_route(const std::vector<RouteScore>& scores);

}  // namespace wavecurve::verification
