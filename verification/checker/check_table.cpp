#include "verification/checker/check_table.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "verification/checker/find_routes.hpp"
#include "verification/checker/gather_columns.hpp"
#include "verification/checker/judged_column.hpp"
#include "verification/prints/column_errors.hpp"
#include "verification/prints/judge_print.hpp"
#include "verification/quantities/other_solution.hpp"

namespace wavecurve::verification {

namespace {

void judge_alone(JudgedRow& row, const ColumnForm& column) {
  JudgedPrint judged = judge_print(row.value, row.result.entry.number, column);
  row.result.ulps = distance_in_units(row.value, row.result.entry.number);
  row.result.verdict = judged.verdict;
  row.result.detail = std::move(judged.detail);
  row.wrong = judged.wrong;
  row.repair = std::move(judged.repair);
  row.in_column_form = std::move(judged.in_column_form);
}

/// Tells the rows that are as far off as their column is all over, and drops what explains such a one
/// only by chance. An edit that leaves no digit but those of the right number, such as a lost sign, speaks for
/// itself; another needs a column that is otherwise accurate.
void compare_errors(std::vector<JudgedRow>& rows) {
  const auto keeps_digits = [](const JudgedRow& row) {
    return row.repair->repaired.significand() == row.result.entry.number.significand();
  };
  std::vector<PrintError> errors(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const JudgedRow& row = rows[i];
    if (!row.wrong || row.result.entry.number.is_fraction()) continue;
    const bool is_padded = without_padding(row.value, row.result.entry.number).has_value();
    const bool inaccurate = !is_padded && (!row.repair || row.repair->only_last_digit);
    errors[i] = error_of(row.value, row.result.entry.number, inaccurate);
  }
  const ColumnErrors all(errors);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    JudgedRow& row = rows[i];
    row.has_usual_error = row.wrong && all.are_usual_as(errors[i]);
    if (row.repair && !keeps_digits(row) && row.has_usual_error) row.repair.reset();
  }
}

/// Digits that an edit left in their places are right.
std::size_t end_of_edit(const PrintedNumber& print, const Repair& repair) {
  const std::string& right = repair.repaired.digits;
  const bool in_place = repair.edit == Edit::wrong_digit || repair.edit == Edit::swapped_digits ||
                        repair.edit == Edit::swapped_apart;
  if (!in_place || right.size() != print.digits.size()) return 0;
  const auto last = std::mismatch(right.rbegin(), right.rend(), print.digits.rbegin()).first;
  return static_cast<std::size_t>(right.rend() - last);
}

void judge_wrong(JudgedRow& row, bool yielded_by_route, const std::string& route) {
  CheckedRow& result = row.result;
  result.departure = departure(row.value, result.entry.number);
  if (yielded_by_route) {
    result.verdict = PrintVerdict::published_route;
    result.detail = describe_difference(*result.departure, result.entry.number);
    result.route = route;
    return;
  }
  JudgedPrint judged =
      judge_wrong_print(row.value, result.entry.number, row.repair, !row.has_usual_error);
  result.verdict = judged.verdict;
  result.detail = std::move(judged.detail);
  if (result.verdict == PrintVerdict::form) result.departure.reset();
  if (judged.repair) result.departure->end = end_of_edit(result.entry.number, *judged.repair);
}

/// What taps are that are not those of the filter that they are said to be.
std::string solution_of(const JudgedColumn& column) {
  const auto wrong = std::count_if(
      column.rows.begin(), column.rows.end(),
      [](const JudgedRow& row) { return row.result.verdict == PrintVerdict::discrepant; });
  const auto rows = static_cast<std::ptrdiff_t>(column.rows.size());
  if (!is_taps(column.result.quantity) || 2 * wrong <= rows) return "";
  std::map<EntryIndex, double> in_order;
  for (const JudgedRow& row : column.rows) {
    in_order[row.result.entry.index] = row.result.entry.number.to_double();
  }
  std::vector<double> taps;
  for (const auto& [index, value] : in_order) taps.push_back(value);
  return describe_solution(taps);
}

void finish(JudgedColumn& column, const std::optional<CreditedRoute>& credit,
            std::vector<RouteScore> scores) {
  const RouteScore& route = scores[credit ? credit->route : 0];
  CheckedColumn& result = column.result;
  result.route = route.name;
  result.matched = route.matched;
  result.after_edit = route.after_edit;
  result.allowance = route.allowance;
  result.credited = credit.has_value();
  if (credit) {
    result.chance = credit->chance;
    result.other_columns = static_cast<int>(credit->columns) - 1;
  }
  std::size_t explained = 0;
  for (JudgedRow& row : column.rows) {
    const bool yielded = row.may_have_a_route() && route.yields_print[explained++];
    row.result.certified =
        certified_text(row.value, row.result.entry.number, column.form, row.wrong);
    if (row.wrong) judge_wrong(row, result.credited && yielded, route.name);
  }
  result.of = static_cast<int>(explained);
  result.solution = solution_of(column);
  if (column.is_right()) scores.resize(1);
  result.routes = std::move(scores);
}

// --- a column as a whole ---

void find_form(JudgedColumn& column) {
  std::vector<PrintedNumber> prints;
  for (const JudgedRow& row : column.rows) prints.push_back(row.result.entry.number);
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
  const auto is_understood = [](const CheckedColumn& column) {
    return column.convention.is_the_librarys() || column.convention.stated;
  };
  return std::all_of(columns.begin(), columns.end(), is_understood) &&
         std::all_of(rows.begin(), rows.end(), [](const CheckedRow& row) {
           return row.verdict == PrintVerdict::certified || row.verdict == PrintVerdict::form;
         });
}

CheckedTable check_table(const PublishedTable& table) {
  CheckedTable result{table.file, table.title, table.extra_columns, {}, {}, {}};
  for (const PublishedEntry& entry : table.entries) {
    result.rows.push_back({entry, PrintVerdict::undecided, "", 0, "", ""});
  }
  TableFilters filters;
  std::vector<JudgedColumn> columns = gather_columns(table, result.rows, filters);
  for (JudgedColumn& column : columns) {
    find_form(column);
    for (JudgedRow& row : column.rows) judge_alone(row, column.form);
    compare_errors(column.rows);
  }
  FoundRoutes found = find_routes(columns);
  result.habits = std::move(found.habits);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    finish(columns[c], found.credits[c], std::move(found.scores[c]));
    result.columns.push_back(std::move(columns[c].result));
  }
  return result;
}

}  // namespace wavecurve::verification
