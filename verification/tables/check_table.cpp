#include "verification/tables/check_table.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "verification/tables/column_errors.hpp"
#include "verification/tables/judge_print.hpp"
#include "verification/tables/published_taps.hpp"
#include "verification/tables/routes.hpp"
#include "verification/tables/true_value.hpp"

namespace wavecurve::verification {

namespace {

/// A row while it is worked on.
struct Row {
  CheckedRow& result;
  TrueValue value;
  bool wrong = false;  ///< proved not to be the rounded value, in whatever form
  std::optional<Repair> repair;

  /// A fraction is not the outcome of a computation in floating point: no route explains it.
  bool may_have_a_route() const { return !result.entry.number.is_fraction(); }
};

struct Column {
  CheckedColumn result;
  FilterValues& filter;
  ColumnForm form;
  std::vector<Row> rows;
  std::map<int, std::size_t> row_of_index;
};

// --- what needs no search ---

void judge_alone(Row& row, const ColumnForm& column) {
  JudgedPrint judged = judge_print(row.value, row.result.entry.number, column);
  row.result.verdict = judged.verdict;
  row.result.detail = std::move(judged.detail);
  row.wrong = judged.wrong;
  row.repair = std::move(judged.repair);
}

/// An edit that leaves no digit but those of the right number, such as a lost sign, speaks for
/// itself. Another needs a column that is otherwise accurate.
void drop_chance_repairs(std::vector<Row>& rows) {
  const auto keeps_digits = [](const Row& row) {
    return row.repair->repaired.significand() == row.result.entry.number.significand();
  };
  std::vector<PrintError> errors(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    if (!row.wrong || row.result.entry.number.is_fraction()) continue;
    const bool inaccurate = !row.repair || row.repair->only_last_digit;
    errors[i] = error_of(row.value, row.result.entry.number, inaccurate);
  }
  const ColumnErrors all(errors);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::optional<Repair>& repair = rows[i].repair;
    if (repair && !keeps_digits(rows[i]) && all.are_usual_as(errors[i])) repair.reset();
  }
}

// --- the route of a column ---

/// alpha as the table itself prints it, if it prints all that do not vanish by structure.
Eigen::VectorXd printed_alpha(const std::vector<Column>& columns, const FilterValues& filter) {
  Eigen::VectorXd alpha = Eigen::VectorXd::Zero(filter.number_of_taps());
  std::vector<bool> known(static_cast<std::size_t>(alpha.size()), false);
  for (const Column& column : columns) {
    if (&column.filter != &filter) continue;
    if (column.result.quantity != Quantity::autocorrelation) continue;
    for (const Row& row : column.rows) {
      const int n = std::abs(row.result.entry.index);
      alpha[n] = row.result.entry.number.to_double();
      known[static_cast<std::size_t>(n)] = true;
    }
  }
  for (std::size_t n = 0; n < known.size(); ++n) {
    const bool vanishes = filter.is_orthonormal() && n > 0 && n % 2 == 0;
    if (!known[n] && !vanishes) return {};
  }
  return alpha;
}

Eigen::VectorXd true_taps(FilterValues& filter) {
  Eigen::VectorXd taps(filter.number_of_taps());
  for (int i = 0; i < filter.number_of_taps(); ++i) {
    taps[i] = filter.value(Quantity::taps, filter.first_tap() + i).to_double();
  }
  return taps;
}

RouteInput route_input(const Column& column, const std::vector<Column>& columns) {
  RouteInput input;
  input.taps = true_taps(column.filter);
  if (const auto published = find_published_taps(column.filter.name())) {
    input.published_taps = published->taps;
    input.published_taps_name = published->name;
  }
  input.printed_alpha = printed_alpha(columns, column.filter);
  input.orthonormal = column.filter.is_orthonormal();
  input.decimals = column.form.form.digits;
  return input;
}

ColumnToExplain column_to_explain(const Column& column) {
  ColumnToExplain result{column.result.quantity, column.form.form, {}};
  for (const Row& row : column.rows) {
    if (!row.may_have_a_route()) continue;
    const PublishedEntry& entry = row.result.entry;
    const int place =
        is_taps(entry.quantity) ? entry.index - column.filter.first_tap() : std::abs(entry.index);
    EntryToExplain explained{static_cast<std::size_t>(place), entry.number, std::nullopt, row.wrong,
                             row.value.to_double()};
    if (row.repair) explained.repaired = row.repair->repaired;
    result.entries.push_back(std::move(explained));
  }
  return result;
}

// --- the verdicts of what is wrong ---

void judge_wrong(Row& row, bool yielded_by_route, const std::string& route) {
  CheckedRow& result = row.result;
  if (yielded_by_route) {
    result.verdict = PrintVerdict::published_route;
    result.detail = describe_difference(row.value, result.entry.number);
    result.route = route;
    return;
  }
  JudgedPrint judged = judge_wrong_print(row.value, result.entry.number, row.repair);
  result.verdict = judged.verdict;
  result.detail = std::move(judged.detail);
}

void finish(Column& column, const RouteScore& route) {
  column.result.route = route.name;
  column.result.matched = route.matched;
  column.result.after_edit = route.after_edit;
  std::size_t explained = 0;
  for (Row& row : column.rows) {
    const PrintedNumber& print = row.result.entry.number;
    const bool yielded = row.may_have_a_route() && route.yields_print[explained++];
    row.result.ulps = distance_in_units(row.value, print);
    row.result.certified = certified_text(row.value, print, column.form, row.wrong);
    if (row.wrong) judge_wrong(row, yielded, route.name);
  }
  column.result.of = static_cast<int>(explained);
}

// --- the columns of a table ---

/// Filters of a table under their canonical names; a filter's values stay where they are.
class Filters {
 public:
  FilterValues& find(const std::string& name) {
    const auto known = by_table_name_.find(name);
    if (known != by_table_name_.end()) return *known->second;
    certified::FilterDefinition definition = find_table_filter(name);
    // A user's file may call itself what it likes.
    const std::string canonical = name.ends_with(".json") ? name : definition.name;
    auto& values = by_canonical_name_[canonical];
    if (!values) values = std::make_unique<FilterValues>(std::move(definition));
    by_table_name_[name] = values.get();
    return *values;
  }

 private:
  std::map<std::string, FilterValues*> by_table_name_;
  std::map<std::string, std::unique_ptr<FilterValues>> by_canonical_name_;
};

/// The columns in the order in which the table begins them.
class Columns {
 public:
  explicit Columns(Filters& filters) : filters_(filters) {}

  void add_row(CheckedRow& result) {
    FilterValues& filter = filters_.find(result.entry.filter);
    Column& column = column_of(filter, result.entry);
    const auto [known, is_new] =
        column.row_of_index.emplace(result.entry.index, column.rows.size());
    if (!is_new) refuse_repetition(column.rows[known->second].result.entry, result.entry);
    column.rows.push_back(
        {result, filter.value(result.entry.quantity, result.entry.index), false, std::nullopt});
  }

  std::vector<Column> take() { return std::move(columns_); }

 private:
  Column& column_of(FilterValues& filter, const PublishedEntry& entry) {
    const auto [known, is_new] =
        places_.emplace(std::pair(&filter, entry.quantity), columns_.size());
    if (is_new) {
      columns_.push_back(
          {{entry.filter, entry.quantity, 0, false, "", 0, 0, 0, {}}, filter, {}, {}, {}});
    }
    return columns_[known->second];
  }

  [[noreturn]] static void refuse_repetition(const PublishedEntry& known,
                                             const PublishedEntry& entry) {
    throw std::invalid_argument(fmt::format("the row repeats line {} ({} and {} are one filter)",
                                            known.line, known.filter, entry.filter));
  }

  Filters& filters_;
  std::vector<Column> columns_;
  std::map<std::pair<FilterValues*, Quantity>, std::size_t> places_;
};

void find_form(Column& column) {
  std::vector<PrintedNumber> prints;
  for (const Row& row : column.rows) prints.push_back(row.result.entry.number);
  column.form = column_form(prints);
  column.result.digits = column.form.form.digits;
  column.result.scientific = column.form.form.scientific;
}

}  // namespace

std::map<PrintVerdict, int> CheckedTable::counts() const {
  std::map<PrintVerdict, int> result;
  for (const CheckedRow& row : rows) ++result[row.verdict];
  return result;
}

bool CheckedTable::is_right() const {
  return std::all_of(rows.begin(), rows.end(), [](const CheckedRow& row) {
    return row.verdict == PrintVerdict::certified || row.verdict == PrintVerdict::form;
  });
}

CheckedTable check_table(const PublishedTable& table) {
  CheckedTable result{table.file, table.title, table.extra_columns, {}, {}};
  for (const PublishedEntry& entry : table.entries) {
    result.rows.push_back({entry, PrintVerdict::undecided, "", 0, "", ""});
  }
  Filters filters;
  Columns read(filters);
  for (CheckedRow& row : result.rows) {
    try {
      read.add_row(row);
    } catch (const std::logic_error& error) {  // invalid_argument and domain_error
      throw std::invalid_argument(table.location(row.entry) + error.what());
    }
  }
  std::vector<Column> columns = read.take();
  for (Column& column : columns) {
    find_form(column);
    for (Row& row : column.rows) judge_alone(row, column.form);
    drop_chance_repairs(column.rows);
  }
  for (Column& column : columns) {
    column.result.routes = score_routes(column_to_explain(column), route_input(column, columns));
    finish(column, best_route(column.result.routes));
    result.columns.push_back(std::move(column.result));
  }
  return result;
}

}  // namespace wavecurve::verification
