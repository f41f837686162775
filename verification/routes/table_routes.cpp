#include "verification/routes/table_routes.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "verification/routes/route_chance.hpp"

namespace wavecurve::verification {

namespace {

bool has(const RouteScore& score, const std::string& habit) {
  return std::find(score.habits.begin(), score.habits.end(), habit) != score.habits.end();
}

bool is_better_than_the_truth(const RouteScore& score, const ColumnScores& column) {
  return score.explains() && score.own > 0 && score.matched > column.front().matched;
}

int trials_of(const ColumnScores& column) {
  int trials = 0;
  for (const RouteScore& score : column) trials += score.trials;
  return trials;
}

/// A habit in one column: how often it was tried there, and its best route.
struct Trial {
  int trials = 0;
  bool explained = false;
  double chance = 1;
};

using Trials = std::map<std::size_t, Trial>;  ///< by column

std::map<std::string, Trials> trials_of_habits(const std::vector<ColumnScores>& columns) {
  std::map<std::string, Trials> result;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    for (const RouteScore& score : columns[c]) {
      for (const std::string& habit : score.habits) {
        Trial& trial = result[habit][c];
        trial.trials += score.trials;
        if (!score.explains()) continue;
        trial.explained = true;
        trial.chance = std::min(trial.chance, score.chance);
      }
    }
  }
  return result;
}

TableHabit judged(const std::string& name, const Trials& trials, std::size_t number_of_habits) {
  TableHabit habit{name, {}, {}, static_cast<double>(number_of_habits)};
  for (const auto& [column, trial] : trials) {
    (trial.explained ? habit.explained : habit.unexplained).push_back(column);
    if (trial.explained) habit.chance *= std::min(1.0, trial.chance * trial.trials);
  }
  const int tried = static_cast<int>(trials.size());
  const int explained = static_cast<int>(habit.explained.size());
  habit.chance = std::min(1.0, habit.chance * ways_to_choose(tried, explained) * tried);
  habit.chance = std::max(habit.chance, least_chance);
  return habit;
}

}  // namespace

std::vector<std::string> likely_habits(const std::vector<ColumnScores>& columns) {
  std::set<std::string> habits;
  for (const ColumnScores& column : columns) {
    for (const RouteScore& score : column) {
      if (is_better_than_the_truth(score, column)) {
        habits.insert(score.habits.begin(), score.habits.end());
      }
    }
  }
  return {habits.begin(), habits.end()};
}

std::vector<TableHabit> find_habits(const std::vector<ColumnScores>& columns) {
  const std::vector<std::string> likely = likely_habits(columns);
  if (likely.empty()) return {};
  const auto all = trials_of_habits(columns);
  std::vector<TableHabit> habits;
  for (const std::string& name : likely) {
    TableHabit habit = judged(name, all.at(name), all.size());
    if (habit.chance < credible_chance) habits.push_back(std::move(habit));
  }
  return habits;
}

std::vector<std::optional<CreditedRoute>> credit_routes(const std::vector<ColumnScores>& columns,
                                                        const std::vector<TableHabit>& habits) {
  std::vector<std::optional<CreditedRoute>> credits(columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const int trials = trials_of(columns[c]);
    for (std::size_t route = 0; route < columns[c].size(); ++route) {
      const RouteScore& score = columns[c][route];
      if (!is_better_than_the_truth(score, columns[c])) continue;
      CreditedRoute credit{route, std::min(1.0, score.chance * trials), "", 1};
      for (const TableHabit& habit : habits) {
        const bool is_shared = habit.explained.size() > 1 && has(score, habit.name);
        if (is_shared && habit.chance < credit.chance) {
          credit = {route, habit.chance, habit.name, habit.explained.size()};
        }
      }
      const bool is_best = !credits[c] || score.matched > columns[c][credits[c]->route].matched;
      if (credit.chance < credible_chance && is_best) credits[c] = credit;
    }
  }
  return credits;
}

}  // namespace wavecurve::verification
