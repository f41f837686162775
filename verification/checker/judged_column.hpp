#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "verification/checker/check_table.hpp"
#include "verification/prints/misprint.hpp"
#include "verification/prints/print_form.hpp"
#include "verification/prints/true_value.hpp"
#include "verification/quantities/convention.hpp"
#include "verification/quantities/filter_values.hpp"

namespace wavecurve::verification {

// What check_table.cpp and find_routes.cpp know about a column while they work on it.

/// A row while it is worked on.
struct JudgedRow {
  CheckedRow& result;
  TrueValue value;
  bool wrong = false;  ///< proved not to be the rounded value, in whatever form
  std::optional<Repair> repair;
  bool has_usual_error = false;  ///< as far off as its column is all over (column_errors.hpp)
  /// The right number in its column's form, where only this equals the print.
  std::optional<PrintedNumber> in_column_form;

  /// A fraction is not the outcome of a computation in floating point: no route explains it.
  bool may_have_a_route() const { return !result.entry.number.is_fraction(); }
};

struct JudgedColumn {
  CheckedColumn result;
  FilterValues& filter;
  Convention convention;
  ColumnForm form;
  std::vector<JudgedRow> rows;

  /// Nothing in it is wrong.
  bool is_right() const {
    return std::none_of(rows.begin(), rows.end(), [](const JudgedRow& row) { return row.wrong; });
  }
};

}  // namespace wavecurve::verification
