#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/tables/column_routes.hpp"
#include "verification/tables/print_verdict.hpp"
#include "verification/tables/published_table.hpp"

namespace wavecurve::verification {

struct CheckedRow {
  PublishedEntry entry;
  PrintVerdict verdict = PrintVerdict::undecided;
  /// The true value, correctly rounded (proved) to the number of decimals of the column, or of the
  /// print where that has more and they differ.
  std::string certified;
  /// |print - true value| in units of the print's last digit; not a number for a fraction.
  double ulps = 0;
  std::string detail;
  std::string route;  ///< the computation that yields the print, for published-route
};

/// The rows of one filter and quantity.
struct CheckedColumn {
  std::string filter;
  Quantity quantity = Quantity::taps;
  /// Decimals (in scientific notation: significant digits) of most of its prints; if several are as
  /// common, the largest. A bare 0 has no say.
  int digits = 0;
  bool scientific = false;
  /// The computation that yields most of its entries.
  std::string route;
  int matched = 0;     ///< entries that it yields, those in need of an edit included
  int after_edit = 0;  ///< of these, the misprints: yielded but for the edit
  int of = 0;
  std::vector<RouteScore> routes;  ///< all that were tried; one, if nothing is wrong
};

struct CheckedTable {
  std::string file, title;
  std::vector<std::string> extra_columns;  ///< names of what stands in PublishedEntry::extra
  std::vector<CheckedRow> rows;            ///< in the order of the table
  std::vector<CheckedColumn> columns;

  std::map<PrintVerdict, int> counts() const;
  /// True if every value is right: certified, or right but for its form.
  bool is_right() const;
};

/// Holds every number of a table against the true value. Each row gets the first verdict that fits:
///
/// undecided         the rounding is open at precision_limit_bits (true_value.hpp).
/// certified         the print is the true value correctly rounded to the print's own last digit,
///                   and has as many decimals as its column (print_form.hpp: the habit of its
///                   notation). A bare 0 is certified if the value is exactly zero, a fraction if
///                   it is the value. Of an exact tie either neighbour is. "-0.000" is if the value
///                   is proved negative.
/// form              correctly rounded as well, but printed with other decimals than its column; or
///                   equal as a number to the rounding at the column's decimals
///                   ("0.0000000000000").
/// published-route   the column's best route (routes.hpp) yields the printed digits. A route is
///                   credited only if it yields at least two entries that the true values do not,
///                   and more entries in all than they do. No route is looked for a fraction.
/// agrees-to-digits  less than one unit of the print's last digit away, or the neighbour of the
///                   correct rounding.
/// form              correctly rounded to fewer decimals and then filled up with zeros, three
///                   significant digits at least before them.
/// misprint          one edit turns the print into the certified rounding (misprint.hpp), and the
///                   column is not as inaccurate all over (column_errors.hpp); or only the sign
///                   keeps it from agreeing to within a unit.
/// agrees-to-digits  at least three significant digits are right: |print - value| is less than one
///                   unit of the third.
/// discrepant        fewer.
///
/// Throws std::invalid_argument "FILE:LINE: ..." for an unknown filter, an index that is out of
/// range, an integral that does not exist, or a row that repeats another under a second name.
CheckedTable check_table(const PublishedTable& table);

}  // namespace wavecurve::verification
