#include "verification/routes/table_routes.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "verification/routes/route_chance.hpp"

namespace wavecurve::verification {
namespace {

/// A score of a column of `of` entries, as many of them wrong as the route yields more than `right`.
RouteScore yielding(const std::string& name, int matched, int right, int of, double chance) {
  RouteScore score;
  score.name = name;
  score.habits = {name};
  score.matched = matched;
  score.own = std::max(0, matched - right);
  score.chance = chance;
  score.yields_print.assign(static_cast<std::size_t>(of), false);
  return score;
}

ColumnScores column(int right, int of, std::vector<RouteScore> routes) {
  ColumnScores scores{yielding("the true values", right, right, of, 1)};
  scores[0].habits.clear();
  scores[0].trials = 0;
  for (RouteScore& route : routes) scores.push_back(std::move(route));
  return scores;
}

std::vector<std::optional<CreditedRoute>> credits(const std::vector<ColumnScores>& columns) {
  return credit_routes(columns, find_habits(columns));
}

TEST(TableRoutes, CreditWhatChanceDoesNotExplain) {
  const auto with = [](double chance) {
    return credits({column(4, 12, {yielding("a", 12, 4, 12, chance)})});
  };
  ASSERT_TRUE(with(1e-8)[0]);
  EXPECT_EQ(with(1e-8)[0]->route, 1U);
  EXPECT_FALSE(with(1e-5)[0]);
}

TEST(TableRoutes, CountTheComputationsThatWereTried) {
  std::vector<RouteScore> routes{yielding("a", 12, 4, 12, 1e-8)};
  for (int i = 0; i < 150; ++i) {
    routes.push_back(yielding("b" + std::to_string(i), 3, 4, 12, 1));
  }
  EXPECT_FALSE(credits({column(4, 12, routes)})[0]);
}

TEST(TableRoutes, AskForNearlyAllEntries) {
  const auto with = [](int matched) {
    return credits({column(0, 16, {yielding("a", matched, 0, 16, 1e-20)})})[0].has_value();
  };
  EXPECT_TRUE(with(16));
  EXPECT_TRUE(with(14));
  EXPECT_FALSE(with(13));
}

TEST(TableRoutes, PoolWhatColumnsHaveInCommon) {
  std::vector<ColumnScores> columns(4, column(4, 8, {yielding("a", 8, 4, 8, 1e-3)}));
  columns.push_back(column(6, 6, {yielding("a", 6, 6, 6, 1)}));  // right, and by this habit too
  const auto habits = find_habits(columns);
  ASSERT_EQ(habits.size(), 1U);
  EXPECT_EQ(habits[0].explained.size(), 5U);
  const auto credited = credit_routes(columns, habits);
  EXPECT_TRUE(credited[0]);
  EXPECT_EQ(credited[0]->columns, 5U);
  EXPECT_LT(credited[0]->chance, 1e-10);
  EXPECT_FALSE(credited[4]) << "nothing is wrong there";
  columns.resize(1);
  EXPECT_FALSE(credits(columns)[0]);
}

TEST(TableRoutes, ColumnsThatAHabitDoesNotExplainSpeakAgainstIt) {
  std::vector<ColumnScores> columns(2, column(4, 8, {yielding("a", 8, 4, 8, 3e-4)}));
  EXPECT_TRUE(credits(columns)[0]);
  for (int i = 0; i < 30; ++i) columns.push_back(column(8, 8, {yielding("a", 3, 8, 8, 1)}));
  EXPECT_FALSE(credits(columns)[0]);
}

TEST(TableRoutes, PreferWhatYieldsMost) {
  const auto credited =
      credits({column(0, 20, {yielding("a", 18, 0, 20, 1e-30), yielding("b", 20, 0, 20, 1e-20)})});
  EXPECT_EQ(credited[0]->route, 2U);
}

}  // namespace
}  // namespace wavecurve::verification
