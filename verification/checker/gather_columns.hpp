#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "verification/checker/judged_column.hpp"
#include "verification/tables/published_table.hpp"

namespace wavecurve::verification {

/// A table of all families has fewer, and the longest filters take a tenth of a second each.
inline constexpr std::size_t most_filters = 200;

/// Filters of a table under their canonical names; a filter's values stay where they are.
class TableFilters {
 public:
  /// Throws as find_table_filter does, and std::invalid_argument for more than most_filters.
  FilterValues& find(const std::string& name);

 private:
  std::map<std::string, FilterValues*> by_table_name_;
  std::map<std::string, std::unique_ptr<FilterValues>> by_canonical_name_;
};

/// The rows of a table by filter and quantity, each column with the convention that it states or
/// that is recognised, and each row with the value that it should print under it. `rows` are those
/// of the table and must outlive the result. A zero that is printed outside the support, as tables
/// that pad their filters do, is one.
/// Throws std::invalid_argument "FILE:LINE: ..." as check_table does.
std::vector<JudgedColumn> gather_columns(const PublishedTable& table, std::vector<CheckedRow>& rows,
                                         TableFilters& filters);

}  // namespace wavecurve::verification
