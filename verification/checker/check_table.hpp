#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "verification/prints/print_form.hpp"
#include "verification/prints/print_verdict.hpp"
#include "verification/quantities/convention.hpp"
#include "verification/routes/column_routes.hpp"
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
  /// Where the print departs from the true value; nothing for a print that is right or only in
  /// another form.
  std::optional<Departure> departure = {};
};

/// The rows of one filter and quantity.
struct CheckedColumn {
  std::string filter;
  Quantity quantity;
  /// How it departs from the library's own order, sign and factor, stated by the table or
  /// recognised; in words, empty if it does not; and the package that prints so, if one is known.
  Convention convention;
  std::string convention_text, known_as;
  /// What the taps are by their own equations, where most are not those of the filter.
  std::string solution;
  /// Decimals (in scientific notation: significant digits) of most of its prints; if several are as
  /// common, the largest. A bare 0 has no say.
  int digits = 0;
  bool scientific = false;
  /// The computation that explains it, beyond chance; if there is none, the true values.
  std::string route;
  int matched = 0;     ///< entries that it yields, those in need of an edit included
  int after_edit = 0;  ///< of these, the misprints: yielded but for the edit
  int of = 0;
  bool credited = false;  ///< to a computation
  double chance = 1;      ///< of that, as CreditedRoute has it
  double allowance = 0;   ///< for the computation's rounding errors, in last units, the largest
  int other_columns = 0;  ///< that the chance is pooled over
  std::vector<RouteScore> routes;  ///< all that were tried; one, if nothing is wrong
};

/// What columns of the table have in common, beyond chance.
struct CheckedHabit {
  std::string name;
  int matched = 0, of = 0;          ///< entries of the columns that it explains
  int columns = 0, of_columns = 0;  ///< those, and all in which it was tried
  double chance = 1;
  /// Entries of the columns that it explains, and other columns: "db4 h_3", "db5 h".
  std::vector<std::string> exceptions;
};

struct CheckedTable {
  std::string file, title;
  std::vector<std::string> extra_columns;  ///< names of what stands in PublishedEntry::extra
  std::vector<CheckedRow> rows;            ///< in the order of the table
  std::vector<CheckedColumn> columns;
  std::vector<CheckedHabit> habits;  ///< of several columns

  std::map<PrintVerdict, int> counts() const;
  /// True if every value is right, certified or right but for its form, under the library's own
  /// convention or one that the table states.
  bool is_right() const;
};

/// Holds every number of a table against the true value. Each row gets the first verdict that fits:
///
/// undecided         the rounding is open at precision_limit_bits (true_value.hpp).
/// certified         the print is the true value correctly rounded to the print's own last digit,
///                   and has as many decimals as its column (print_form.hpp: the habit of its
///                   notation). A bare 0 is certified if the value is exactly zero, a fraction if
///                   it is the value. Either neighbour of an exact tie is. "-0.000" is if the value
///                   is proved negative.
/// form              correctly rounded as well, but printed with other decimals than its column; or
///                   equal as a number to the rounding at the column's decimals
///                   ("0.0000000000000").
/// published-route   the column's credited route yields the printed digits, and the true value does
///                   not. A route (routes.hpp) is credited only if it yields nearly all entries,
///                   and an unrelated computation as accurate would do as well with a probability
///                   below 1e-6 (table_routes.hpp). No route is looked for a fraction.
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
/// A column that is reversed, negated, shifted or scaled as a whole is recognised and judged as what
/// it is (convention.hpp).
///
/// Throws std::invalid_argument "FILE:LINE: ..." for an unknown filter, an index that is out of
/// range, an integral that does not exist, or a row that repeats another under a second name.
CheckedTable check_table(const PublishedTable& table);

}  // namespace wavecurve::verification
