#include "verification/checker/gather_columns.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace wavecurve::verification {

namespace {

/// Collects rows into columns; where a column stands, and which indices it has, is looked up.
class Collector {
 public:
  Collector(TableFilters& filters, std::vector<JudgedColumn>& columns)
      : filters_(filters), columns_(columns) {}

  void add(CheckedRow& row) {
    FilterValues& filter = filters_.find(row.entry.filter);
    const std::size_t place = place_of(filter, row.entry);
    const auto [seen, is_new] = indices_[place].emplace(row.entry.index, &row.entry);
    if (!is_new) refuse_repetition(*seen->second, row.entry);
    columns_[place].rows.push_back({row, {}, false, {}, false, {}});
  }

 private:
  std::size_t place_of(FilterValues& filter, const PublishedEntry& entry) {
    const auto [known, is_new] =
        places_.emplace(std::pair(&filter, to_string(entry.quantity)), columns_.size());
    if (is_new) {
      CheckedColumn column;
      column.filter = entry.filter;
      column.quantity = entry.quantity;
      columns_.push_back({std::move(column), filter, {}, {}, {}});
      indices_.emplace_back();
    }
    return known->second;
  }

  [[noreturn]] static void refuse_repetition(const PublishedEntry& first,
                                             const PublishedEntry& entry) {
    throw std::invalid_argument(fmt::format("the row repeats line {} ({} and {} are one filter)",
                                            first.line, first.filter, entry.filter));
  }

  TableFilters& filters_;
  std::vector<JudgedColumn>& columns_;
  std::map<std::pair<FilterValues*, std::string>, std::size_t> places_;
  std::vector<std::map<EntryIndex, const PublishedEntry*>> indices_;
};

Convention natural(const StatedConvention& stated, const JudgedColumn& column) {
  Convention convention = stated.convention;
  if (!stated.from_zero) return convention;
  const auto [first, last] =
      column.filter.index_range(listed_quantity(column.result.quantity, convention));
  convention.shift = convention.reversed ? -first : first;
  return convention;
}

Convention convention_of(const JudgedColumn& column,
                         const std::optional<StatedConvention>& stated) {
  std::vector<EntryToPlace> entries;
  for (const JudgedRow& row : column.rows) {
    const PrintedNumber& print = row.result.entry.number;
    entries.push_back(
        {row.result.entry.index, print.to_double(), certified::Ball(print.unit()).to_double()});
  }
  const auto found = recognise_convention(column.filter, column.result.quantity, entries, stated);
  if (found) return *found;
  return stated ? natural(*stated, column) : Convention{};
}

bool is_outside(FilterValues& filter, const Quantity& quantity, const Convention& convention,
                const EntryIndex& index) {
  const EntryIndex source = source_index(filter, quantity, convention, index);
  const auto [first, last] = filter.index_range(listed_quantity(quantity, convention));
  return source.first < first || source.first > last;
}

TrueValue value_of(const JudgedColumn& column, const PublishedEntry& entry) {
  const Quantity& quantity = entry.quantity;
  const bool is_padded = quantity.family->name == "h" && entry.number.is_zero() &&
                         entry.index.is_integer() &&
                         is_outside(column.filter, quantity, column.convention, entry.index);
  if (is_padded) return {certified::Rational(0), {}};
  return conventional_value(column.filter, quantity, column.convention, entry.index);
}

/// Runs a step for a row, and puts file and line before what it throws.
template <class Step>
void at_row(const PublishedTable& table, const CheckedRow& row, Step step) {
  try {
    step();
  } catch (const std::logic_error& error) {  // invalid_argument and domain_error
    throw std::invalid_argument(table.location(row.entry) + error.what());
  }
}

}  // namespace

FilterValues& TableFilters::find(const std::string& name) {
  const auto known = by_table_name_.find(name);
  if (known != by_table_name_.end()) return *known->second;
  if (by_canonical_name_.size() >= most_filters) {
    throw std::invalid_argument(
        fmt::format("the table names more than {} filters; check it in parts", most_filters));
  }
  certified::FilterDefinition definition = find_table_filter(name);
  // A user's file may call itself what it likes.
  const std::string canonical = name.ends_with(".json") ? name : definition.name;
  auto& values = by_canonical_name_[canonical];
  if (!values) values = std::make_unique<FilterValues>(std::move(definition));
  by_table_name_[name] = values.get();
  return *values;
}

std::vector<JudgedColumn> gather_columns(const PublishedTable& table, std::vector<CheckedRow>& rows,
                                         TableFilters& filters) {
  std::vector<JudgedColumn> columns;
  Collector collector(filters, columns);
  for (CheckedRow& row : rows) at_row(table, row, [&] { collector.add(row); });
  for (JudgedColumn& column : columns) {
    at_row(table, column.rows.front().result,
           [&] { column.convention = convention_of(column, table.convention); });
    for (JudgedRow& row : column.rows) {
      at_row(table, row.result, [&] { row.value = value_of(column, row.result.entry); });
    }
    CheckedColumn& result = column.result;
    result.convention = column.convention;
    result.convention_text = describe(column.filter, result.quantity, column.convention);
    result.known_as = known_as(column.filter, result.quantity, column.convention);
  }
  return columns;
}

}  // namespace wavecurve::verification
