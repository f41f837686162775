#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/routes/routes.hpp"

namespace wavecurve::verification {

/// An entry of a column as the search for its route sees it.
struct EntryToExplain {
  std::size_t place = 0;  ///< in the vectors of a Route
  PrintedNumber print;
  std::optional<PrintedNumber> repaired;  ///< the right number, if one edit leads there
  bool wrong = false;                     ///< proved not to be the rounded true value
  double distance = 0;                    ///< |print - true value| in units of its last digit
};

/// How well a route explains a column.
struct RouteScore {
  std::string name;
  std::vector<std::string> habits;
  int matched = 0;       ///< entries whose digits it yields, up to the edit of a misprint
  int after_edit = 0;    ///< of these, the ones that need the edit
  int own = 0;           ///< wrong entries that it yields as they are printed
  double farthest = 0;   ///< largest distance from a print (edited where needed), in its last unit
  double allowance = 0;  ///< the largest made for rounding errors, in last units
  int trials = 1;        ///< how often it was held against the column: with and without allowance
  double chance = 1;     ///< that an unrelated computation of the same accuracy
                         ///< yields as many; 1 if it does not explain the column
  std::vector<bool> yields_print;  ///< for each entry, without an edit
  std::vector<bool> yields;        ///< up to the edit of a misprint

  /// It yields all of the column's entries but one in eight.
  bool explains() const;
};

/// The scores of the true values, correctly rounded, and of every route, in this order.
///
/// Whether a rounding rule yields a print is decided exactly, at the print's own last digit, with
/// no allowance. A floating-point computation is first held against the prints as it is, then with
/// an allowance for its rounding errors, of each entry at most half the distance between print and
/// true value; the second counts if it explains the column and yields more.
std::vector<RouteScore> score_routes(const std::vector<EntryToExplain>& entries,
                                     const std::vector<Route>& routes);

/// The score of the true values alone: what a column in which nothing is wrong has.
RouteScore score_of_true_values(const std::vector<EntryToExplain>& entries);

}  // namespace wavecurve::verification
