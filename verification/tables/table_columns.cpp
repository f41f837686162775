#include "verification/tables/table_columns.hpp"

#include <algorithm>
#include <stdexcept>

#include "wavecurve/io/files/detail/csv.hpp"
#include "wavecurve/io/files/detail/text.hpp"

#include "verification/prints/printed_number.hpp"

namespace wavecurve::verification {

namespace {

/// Each column is known by the first of its names that the header has.
using ColumnNames = std::vector<std::string_view>;
const ColumnNames filter_column{"filter"}, quantity_column{"quantity"}, index_column{"index"},
    printed_column{"printed", "value"};

bool is_known(const std::string& field) {
  for (const ColumnNames& names : {filter_column, quantity_column, index_column, printed_column}) {
    if (std::find(names.begin(), names.end(), io::lower_case(field)) != names.end()) return true;
  }
  return false;
}

std::optional<std::size_t> find_column(const std::vector<std::string>& fields,
                                       const ColumnNames& names) {
  for (const std::string_view name : names) {
    const auto is_it = [name](const std::string& field) { return io::lower_case(field) == name; };
    const auto count = std::count_if(fields.begin(), fields.end(), is_it);
    if (count > 1) {
      throw std::invalid_argument("the header has column '" + std::string(name) + "' twice");
    }
    if (count == 0) continue;
    const auto place = std::find_if(fields.begin(), fields.end(), is_it);
    return static_cast<std::size_t>(place - fields.begin());
  }
  return std::nullopt;
}

std::size_t needed_column(const std::vector<std::string>& fields, const ColumnNames& names,
                          std::string_view header) {
  if (const auto place = find_column(fields, names)) return *place;
  throw std::invalid_argument("the header has no column '" + std::string(names.front()) +
                              "'; a table starts with the line filter,quantity,index,printed, this "
                              "one with " +
                              excerpt(header));
}

/// Nothing where quotes do not fit the separator.
std::vector<std::string> fields_if_any(std::string_view header, char separator) {
  try {
    return io::csv_fields(header, separator);
  } catch (const std::invalid_argument&) {
    return {};
  }
}

}  // namespace

TableColumns parse_table_columns(std::string_view header) {
  TableColumns columns;
  std::vector<std::string> fields;
  std::ptrdiff_t most = 0;
  for (const char separator : {',', ';', '\t'}) {
    std::vector<std::string> found = fields_if_any(header, separator);
    const auto known = std::count_if(found.begin(), found.end(), is_known);
    if (known <= most) continue;
    most = known;
    columns.separator = separator;
    fields = std::move(found);
  }
  if (most == 0) fields = io::csv_fields(header, columns.separator);
  while (!fields.empty() && fields.back().empty()) fields.pop_back();
  columns.count = fields.size();
  if (columns.count > most_columns) {
    throw std::invalid_argument("the header has " + std::to_string(columns.count) +
                                " columns, at most " + std::to_string(most_columns) + " are read");
  }
  columns.filter = find_column(fields, filter_column);
  columns.quantity = find_column(fields, quantity_column);
  columns.index = needed_column(fields, index_column, header);
  columns.printed = needed_column(fields, printed_column, header);
  for (std::size_t place = 0; place < fields.size(); ++place) {
    const bool is_ours = place == columns.filter || place == columns.quantity ||
                         place == columns.index || place == columns.printed;
    if (is_ours) continue;
    columns.extra.push_back(place);
    unique_name(fields[place].empty() ? "column " + std::to_string(place + 1) : fields[place],
                columns.extra_names);
  }
  return columns;
}

std::vector<std::string> parse_table_row(std::string_view row, const TableColumns& columns) {
  std::vector<std::string> fields = io::csv_fields(row, columns.separator);
  while (fields.size() > columns.count && fields.back().empty()) fields.pop_back();
  if (fields.size() == columns.count) return fields;
  throw std::invalid_argument("the row has " + std::to_string(fields.size()) +
                              (fields.size() == 1 ? " field" : " fields") + ", the header has " +
                              std::to_string(columns.count) + " columns: " + excerpt(row));
}

std::string unique_name(const std::string& name, std::vector<std::string>& taken) {
  std::string result = name;
  for (int i = 2; std::find(taken.begin(), taken.end(), result) != taken.end(); ++i) {
    result = name + " (" + std::to_string(i) + ")";
  }
  taken.push_back(result);
  return result;
}

}  // namespace wavecurve::verification
