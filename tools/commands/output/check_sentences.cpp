#include "tools/commands/output/check_sentences.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "verification/routes/route_chance.hpp"

namespace wavecurve::tools {

namespace {

using namespace wavecurve::verification;

std::string form_text(const CheckedColumn& column) {
  return fmt::format("{} {}", column.digits, column.scientific ? "significant digits" : "decimals");
}

std::string chance_text(double chance) {
  return chance <= least_chance ? fmt::format("below {:g}", least_chance)
                                : fmt::format("{:.1g}", chance);
}

std::string column_text(const CheckedColumn& column) {
  std::string text =
      fmt::format("{} {} ({}): {} of {} entries", column.filter, to_string(column.quantity),
                  form_text(column), column.matched, column.of);
  if (column.after_edit > 0) text += fmt::format(", {} after an edit", column.after_edit);
  text += " from " + column.route;
  if (!column.credited) {
    if (column.matched == column.of) return text;
    return text + fmt::format("; none of {} other computations explains the rest",
                              column.routes.size() - 1);
  }
  text += fmt::format(" (chance {}", chance_text(column.chance));
  if (column.other_columns > 0) {
    text += fmt::format(" together with {} other column{}", column.other_columns,
                        column.other_columns == 1 ? "" : "s");
  }
  if (column.allowance > 0) {
    text += fmt::format("; rounding errors of up to {:.2g} units allowed for", column.allowance);
  }
  return text + ")";
}

std::string habit_text(const CheckedHabit& habit) {
  std::string text =
      fmt::format("{} of {} columns, {} of {} entries: {} (chance {})", habit.columns,
                  habit.of_columns, habit.matched, habit.of, habit.name, chance_text(habit.chance));
  constexpr std::size_t most_named = 8;
  for (std::size_t i = 0; i < std::min(habit.exceptions.size(), most_named); ++i) {
    text += (i == 0 ? "; not " : ", ") + habit.exceptions[i];
  }
  if (habit.exceptions.size() > most_named) {
    text += fmt::format(" and {} more", habit.exceptions.size() - most_named);
  }
  return text;
}

/// "db4 h: reversed, as PyWavelets dec_lo (the table does not say so; ...)"
std::string convention_text(const CheckedColumn& column) {
  const std::string package = column.known_as.empty() ? "" : ", as " + column.known_as;
  const std::string stated =
      column.convention.stated
          ? ", as the table states"
          : fmt::format(" (the table does not say so; \"# convention: {}\" would)",
                        column.convention_text);
  return fmt::format("{} {}: {}{}{}", column.filter, to_string(column.quantity),
                     column.convention_text, package, stated);
}

}  // namespace

std::string ulps_text(double ulps, int digits) {
  return std::isnan(ulps) ? "" : fmt::format("{:.{}g}", ulps, digits);
}

std::vector<std::string> convention_sentences(const CheckedTable& table) {
  std::vector<std::string> result;
  for (const CheckedColumn& column : table.columns) {
    if (!column.convention_text.empty()) result.push_back(convention_text(column));
  }
  for (const CheckedColumn& column : table.columns) {
    if (column.solution.empty()) continue;
    result.push_back(fmt::format("{} {}: {}; not the one called {}", column.filter,
                                 to_string(column.quantity), column.solution, column.filter));
  }
  return result;
}

std::vector<std::string> habit_sentences(const CheckedTable& table) {
  std::vector<std::string> result;
  for (const CheckedHabit& habit : table.habits) result.push_back(habit_text(habit));
  return result;
}

std::vector<std::string> route_sentences(const CheckedTable& table) {
  std::vector<std::string> result;
  for (const CheckedColumn& column : table.columns) result.push_back(column_text(column));
  return result;
}

}  // namespace wavecurve::tools
