#include "verification/tables/check_table.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/certified/decimal_enclosure.hpp"
#include "wavecurve/certified/rounding.hpp"

#include "verification/tables/find_routes.hpp"
#include "verification/tables/judged_column.hpp"

namespace wavecurve::verification {

namespace {

constexpr int least_correct_digits = 3;

std::string digits_text(const PrintForm& form) {
  const std::string noun = form.scientific ? "significant digit" : "decimal";
  return fmt::format("{} {}{}", form.digits, noun, form.digits == 1 ? "" : "s");
}

// --- certified, form, undecided: what needs no search ---

bool is_proved_negative(const TrueValue& value) {
  const auto is_negative = [](const certified::Ball& enclosure) {
    if (certainly_less(enclosure, certified::Ball(0))) return Decision::yes;
    return enclosure.contains_zero() && !enclosure.is_exact() ? Decision::undecided : Decision::no;
  };
  return decide(value, is_negative) == Decision::yes;
}

bool is_tie(const TrueValue& value, const PrintedNumber& print) {
  return value.exact &&
         (*value.exact - print.value()).abs() == print.unit() / certified::Rational(2);
}

void set(CheckedRow& row, PrintVerdict verdict, std::string detail) {
  row.verdict = verdict;
  row.detail = std::move(detail);
}

std::string other_form_text(const PrintedNumber& print, const ColumnForm& column) {
  return fmt::format("the right value with {}; its column has {}", digits_text(form_of(print)),
                     digits_text(column.form));
}

void judge_right(JudgedRow& row, const ColumnForm& column) {
  const PrintedNumber& print = row.result.entry.number;
  if (print.is_bare_zero() && row.value.is_exactly_zero()) {
    set(row.result, PrintVerdict::certified, "exactly zero");
  } else if (column.established && form_of(print) != column.form) {
    set(row.result, PrintVerdict::form, other_form_text(print, column));
  } else if (print.is_zero() && print.negative && !is_proved_negative(row.value)) {
    set(row.result, PrintVerdict::form, "the right value with a sign that it does not have");
  } else if (is_tie(row.value, print)) {
    set(row.result, PrintVerdict::certified,
        "an exact tie; either neighbour is a correct rounding");
  } else {
    set(row.result, PrintVerdict::certified, "");
  }
}

/// The print is no correct rounding at its own last digit; it may still be the number that the
/// column's form asks for, with zeros behind it.
std::optional<PrintedNumber> right_number(const JudgedRow& row, const ColumnForm& column) {
  if (!column.established) return std::nullopt;
  auto rounded = round_to_form(row.value, column.form);
  const bool is_equal = rounded && rounded->value() == row.result.entry.number.value();
  return is_equal ? rounded : std::nullopt;
}

void judge_alone(JudgedRow& row, const ColumnForm& column) {
  const PrintedNumber& print = row.result.entry.number;
  row.result.ulps = distance_in_units(row.value, print);
  switch (is_within(row.value, print.value(), print.unit() / certified::Rational(2))) {
    case Decision::yes:
      judge_right(row, column);
      return;
    case Decision::undecided:
      set(row.result, PrintVerdict::undecided,
          fmt::format("the rounding is still open at {} bits", precision_limit_bits));
      return;
    case Decision::no:
      break;
  }
  row.in_column_form = right_number(row, column);
  if (row.in_column_form) {
    set(row.result, PrintVerdict::form, other_form_text(print, column));
    return;
  }
  row.wrong = true;
  row.repair = likeliest_repair(print, intended_prints(row.value, print, column));
}

// --- the verdicts of what is wrong ---

std::string describe_difference(const JudgedRow& row) {
  const PrintedNumber& print = row.result.entry.number;
  const auto right = round_to_form(row.value, form_of(print));
  const int digit = right ? first_wrong_digit(print, *right) : 0;
  return digit > 0 ? fmt::format("the true value differs from significant digit {} on", digit)
                   : "the true value differs";
}

void judge_wrong(JudgedRow& row, bool yielded_by_route, const std::string& route) {
  CheckedRow& result = row.result;
  if (yielded_by_route) {
    result.verdict = PrintVerdict::published_route;
    result.detail = describe_difference(row);
    result.route = route;
    return;
  }
  if (row.repair) {
    result.verdict = PrintVerdict::misprint;
    result.detail = row.repair->description + ": " + row.repair->repaired.text();
    if (row.repair->only_last_digit) {
      result.detail += "; only the last digit, so an inaccurate computation explains it as well";
    }
    return;
  }
  const int correct = correct_digits(row.value, result.entry.number);
  result.verdict =
      correct >= least_correct_digits ? PrintVerdict::agrees_to_digits : PrintVerdict::discrepant;
  result.detail = fmt::format("{} significant digit{} right", correct, correct == 1 ? "" : "s");
  if (is_cut_off(row.value, result.entry.number.value(), result.entry.number.decimals()) ==
      Decision::yes) {
    result.detail += "; the true value cut off instead of rounded";
  } else if (result.ulps <= 1.5 && !row.value.is_exactly_zero()) {
    result.detail += "; one unit in the last digit is a rounding difference";
  }
}

/// The digits that the report shows: the column's, or the print's where it has more and is wrong.
std::string certified_text(const JudgedRow& row, const ColumnForm& column) {
  const PrintForm own = form_of(row.result.entry.number);
  PrintForm shown = column.established ? column.form : own;
  if (row.wrong && own.scientific == shown.scientific) {
    shown.digits = std::max(shown.digits, own.digits);
  }
  const auto rounded = round_to_form(row.value, shown);
  if (rounded) return rounded->text();
  constexpr int most_digits = 15;
  return row.value.exact
             ? certified::round_to_digits(*row.value.exact, most_digits)
             : certified::supported_decimal(row.value.enclosure(precision_limit_bits), most_digits)
                   .value;
}

void finish(JudgedColumn& column, const std::optional<CreditedRoute>& credit,
            std::vector<RouteScore> scores) {
  const RouteScore& route = scores[credit ? credit->route : 0];
  CheckedColumn& result = column.result;
  result.route = route.name;
  result.matched = route.matched;
  result.after_edit = route.after_edit;
  result.of = static_cast<int>(column.rows.size());
  result.allowance = route.allowance;
  result.credited = credit.has_value();
  if (credit) {
    result.chance = credit->chance;
    result.other_columns = static_cast<int>(credit->columns) - 1;
  }
  for (std::size_t i = 0; i < column.rows.size(); ++i) {
    JudgedRow& row = column.rows[i];
    row.result.certified = certified_text(row, column.form);
    if (row.wrong) judge_wrong(row, result.credited && route.yields_print[i], route.name);
  }
  if (column.is_right()) scores.resize(1);
  result.routes = std::move(scores);
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

JudgedColumn& column_of(std::vector<JudgedColumn>& columns, FilterValues& filter,
                        const PublishedEntry& entry) {
  const auto known = std::find_if(columns.begin(), columns.end(), [&](const JudgedColumn& column) {
    return &column.filter == &filter && column.result.quantity == entry.quantity;
  });
  if (known != columns.end()) return *known;
  CheckedColumn result;
  result.filter = entry.filter;
  result.quantity = entry.quantity;
  columns.push_back({std::move(result), filter, {}, {}});
  return columns.back();
}

void refuse_repetition(const JudgedColumn& column, const PublishedEntry& entry) {
  for (const JudgedRow& row : column.rows) {
    if (row.result.entry.index != entry.index) continue;
    throw std::invalid_argument(fmt::format("the row repeats line {} ({} and {} are one filter)",
                                            row.result.entry.line, row.result.entry.filter,
                                            entry.filter));
  }
}

void add_row(std::vector<JudgedColumn>& columns, Filters& filters, CheckedRow& result) {
  FilterValues& filter = filters.find(result.entry.filter);
  JudgedColumn& column = column_of(columns, filter, result.entry);
  refuse_repetition(column, result.entry);
  column.rows.push_back(
      {result, filter.value(result.entry.quantity, result.entry.index), false, {}, {}});
}

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
  return std::all_of(rows.begin(), rows.end(), [](const CheckedRow& row) {
    return row.verdict == PrintVerdict::certified || row.verdict == PrintVerdict::form;
  });
}

CheckedTable check_table(const PublishedTable& table) {
  CheckedTable result{table.file, table.title, {}, {}, {}};
  for (const PublishedEntry& entry : table.entries) {
    result.rows.push_back({entry, PrintVerdict::undecided, "", 0, "", ""});
  }
  Filters filters;
  std::vector<JudgedColumn> columns;
  for (CheckedRow& row : result.rows) {
    try {
      add_row(columns, filters, row);
    } catch (const std::logic_error& error) {  // invalid_argument and domain_error
      throw std::invalid_argument(table.location(row.entry) + error.what());
    }
  }
  for (JudgedColumn& column : columns) {
    find_form(column);
    for (JudgedRow& row : column.rows) judge_alone(row, column.form);
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
