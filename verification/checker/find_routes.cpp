#include "verification/checker/find_routes.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "verification/routes/print_rules.hpp"
#include "verification/routes/routes.hpp"
#include "verification/tables/published_taps.hpp"

namespace wavecurve::verification {

namespace {

/// alpha as the table itself prints it, if it prints all that do not vanish by structure.
Eigen::VectorXd printed_alpha(const std::vector<JudgedColumn>& columns,
                              const FilterValues& filter) {
  Eigen::VectorXd alpha = Eigen::VectorXd::Zero(filter.number_of_taps());
  std::vector<bool> known(static_cast<std::size_t>(alpha.size()), false);
  for (const JudgedColumn& column : columns) {
    if (&column.filter != &filter) continue;
    if (column.result.quantity != Quantity::autocorrelation) continue;
    if (!column.convention.is_the_librarys()) continue;
    for (const JudgedRow& row : column.rows) {
      const int n = std::abs(row.result.entry.index.integer());
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

RouteInput route_input(const JudgedColumn& column, const std::vector<JudgedColumn>& columns) {
  RouteInput input;
  FilterValues& filter = column.filter;
  for (int i = 0; i < filter.number_of_taps(); ++i) {
    input.taps.push_back(filter.value(Quantity::taps, filter.first_tap() + i));
  }
  input.published_taps = find_published_taps(filter.name());
  if (input.published_taps && input.published_taps->numbers.size() != input.taps.size()) {
    input.published_taps.reset();
  }
  input.printed_alpha = printed_alpha(columns, filter);
  input.orthonormal = filter.is_orthonormal();
  input.decimals = column.form.form.digits;
  return input;
}

/// Whether the routes of run_routes yield the column's entries as they stand: its signs are the
/// library's. Rules about its true values apply to any column.
bool has_computations(const JudgedColumn& column) {
  return !column.convention.negated && !column.convention.alternating &&
         !column.convention.exchanged;
}

/// Where an entry stands in the values of a route: taps from the first on, the others by |index|;
/// an entry outside the support behind all of them. Without computations any order will do.
std::size_t place_of(std::size_t row, const JudgedColumn& column) {
  const PublishedEntry& entry = column.rows[row].result.entry;
  const bool is_in_order = entry.index.is_integer() && has_computations(column) &&
                           (is_taps(entry.quantity) || entry.quantity.family->name != "h");
  if (!is_in_order) return row;
  const int source =
      source_index(column.filter, entry.quantity, column.convention, entry.index).integer();
  if (!is_taps(entry.quantity)) return static_cast<std::size_t>(std::abs(source));
  const int place = source - column.filter.first_tap();
  return static_cast<std::size_t>(place < 0 ? column.filter.number_of_taps() : place);
}

std::vector<Route> routes_to(const JudgedColumn& column, const std::vector<JudgedColumn>& columns) {
  std::vector<TrueValue> values;
  for (std::size_t row = 0; row < column.rows.size(); ++row) {
    const std::size_t place = place_of(row, column);
    if (place >= values.size()) values.resize(place + 1, TrueValue{certified::Rational(0), {}});
    values[place] = column.rows[row].value;
  }
  std::vector<Route> routes = print_rules(values);
  if (!has_computations(column)) return routes;
  auto others = run_routes(listed_quantity(column.result.quantity, column.convention),
                           route_input(column, columns));
  std::move(others.begin(), others.end(), std::back_inserter(routes));
  return routes;
}

std::vector<EntryToExplain> entries_to_explain(const JudgedColumn& column) {
  std::vector<EntryToExplain> entries;
  for (std::size_t i = 0; i < column.rows.size(); ++i) {
    const JudgedRow& row = column.rows[i];
    if (!row.may_have_a_route()) continue;
    const PrintedNumber& print = row.in_column_form.value_or(row.result.entry.number);
    entries.push_back(
        {place_of(i, column), print, std::nullopt, row.wrong, distance_in_units(row.value, print)});
    if (row.repair) entries.back().repaired = row.repair->repaired;
  }
  return entries;
}

bool has_habit_of(const Route& route, const std::vector<std::string>& habits) {
  return std::any_of(habits.begin(), habits.end(), [&](const std::string& habit) {
    return std::find(route.habits.begin(), route.habits.end(), habit) != route.habits.end();
  });
}

std::vector<ColumnScores> score_columns(const std::vector<JudgedColumn>& columns) {
  std::vector<ColumnScores> scores;
  for (const JudgedColumn& column : columns) {
    const auto entries = entries_to_explain(column);
    scores.push_back(column.is_right() ? ColumnScores{score_of_true_values(entries)}
                                       : score_routes(entries, routes_to(column, columns)));
  }
  const std::vector<std::string> habits = likely_habits(scores);
  if (habits.empty()) return scores;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (!columns[c].is_right()) continue;
    std::vector<Route> routes = routes_to(columns[c], columns);
    std::erase_if(routes, [&](const Route& route) { return !has_habit_of(route, habits); });
    scores[c] = score_routes(entries_to_explain(columns[c]), routes);
  }
  return scores;
}

/// The score of the habit's best route to the column.
const RouteScore& best_of(const TableHabit& habit, const ColumnScores& scores) {
  const RouteScore* best = nullptr;
  for (const RouteScore& score : scores) {
    if (std::find(score.habits.begin(), score.habits.end(), habit.name) == score.habits.end())
      continue;
    if (!best || score.matched > best->matched) best = &score;
  }
  if (!best) throw std::logic_error("no route of the column has the habit " + habit.name);
  return *best;
}

std::string name_of(const JudgedColumn& column) {
  return fmt::format("{} {}", column.result.filter, to_string(column.result.quantity));
}

CheckedHabit checked_habit(const TableHabit& habit, const std::vector<JudgedColumn>& columns,
                           const std::vector<ColumnScores>& scores) {
  CheckedHabit result{habit.name,
                      0,
                      0,
                      static_cast<int>(habit.explained.size()),
                      static_cast<int>(habit.explained.size() + habit.unexplained.size()),
                      habit.chance,
                      {}};
  for (const std::size_t c : habit.explained) {
    const RouteScore& best = best_of(habit, scores[c]);
    result.matched += best.matched;
    result.of += static_cast<int>(best.yields_print.size());
    std::size_t explained = 0;
    for (const JudgedRow& row : columns[c].rows) {
      if (!row.may_have_a_route() || best.yields[explained++]) continue;
      result.exceptions.push_back(
          fmt::format("{}_{}", name_of(columns[c]), row.result.entry.index.text()));
    }
  }
  for (const std::size_t c : habit.unexplained) result.exceptions.push_back(name_of(columns[c]));
  return result;
}

}  // namespace

FoundRoutes find_routes(const std::vector<JudgedColumn>& columns) {
  FoundRoutes found{score_columns(columns), {}, {}};
  const std::vector<TableHabit> habits = find_habits(found.scores);
  found.credits = credit_routes(found.scores, habits);
  for (const TableHabit& habit : habits) {
    const bool is_credited =
        std::any_of(found.credits.begin(), found.credits.end(),
                    [&](const auto& credit) { return credit && credit->habit == habit.name; });
    if (is_credited) found.habits.push_back(checked_habit(habit, columns, found.scores));
  }
  return found;
}

}  // namespace wavecurve::verification
