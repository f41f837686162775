#include "verification/checker/find_routes.hpp"

#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "verification/checker/check_table.hpp"
#include "verification/routes/print_rules.hpp"
#include "verification/tables/published_taps.hpp"

namespace wavecurve::verification {
namespace {

CheckedTable check(const std::string& rows) {
  return check_table(parse_published_table("filter,quantity,index,printed\n" + rows, "t.csv"));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto place = text.find(from);
  if (place == std::string::npos) throw std::invalid_argument(from + " is not in the table");
  return text.replace(place, from.size(), to);
}

/// Rows of a rule's values, correctly rounded or cut off to so many decimals.
std::string rows_of(const std::string& filter, const Route& route, int decimals) {
  std::string rows;
  for (std::size_t i = 0; i < static_cast<std::size_t>(route.doubles.size()); ++i) {
    PrintedNumber print = *round_to_decimals(
        route.value(i), decimals + (route.printing == Printing::cut_off ? 20 : 0));
    if (route.printing == Printing::cut_off) print.digits.resize(print.digits.size() - 20);
    FilterValues values(find_table_filter(filter));
    rows += filter + ",h," + std::to_string(values.first_tap() + static_cast<int>(i)) + "," +
            print.text() + "\n";
  }
  return rows;
}

std::vector<TrueValue> taps_of(FilterValues& values) {
  std::vector<TrueValue> taps;
  for (int i = 0; i < values.number_of_taps(); ++i) {
    taps.push_back(values.value(Quantity::taps, values.first_tap() + i));
  }
  return taps;
}

TEST(FindRoutes, FindsATableThatWasCutOffInsteadOfRounded) {
  std::string rows;
  std::vector<std::unique_ptr<FilterValues>> filters;
  for (const char* name : {"db2", "db4", "db8", "db9", "db10", "db12", "coif2", "coif4", "sym8"}) {
    filters.push_back(std::make_unique<FilterValues>(find_table_filter(name)));
    rows += rows_of(name, print_rules(taps_of(*filters.back()))[0], 30);
  }
  const CheckedTable table = check(rows);
  const std::string name = "the true values, cut off instead of rounded";
  for (const CheckedColumn& column : table.columns) {
    EXPECT_EQ(column.route, name) << column.filter;
    EXPECT_EQ(column.matched, column.of);
    EXPECT_LT(column.chance, 1e-6);
    EXPECT_EQ(column.allowance, 0);
  }
  ASSERT_EQ(table.habits.size(), 1U);
  EXPECT_EQ(table.habits[0].columns, 9);
  EXPECT_EQ(table.habits[0].matched, 142);
  EXPECT_TRUE(table.habits[0].exceptions.empty());
}

TEST(FindRoutes, NamesTheExceptionFromAHabit) {
  std::string rows;
  std::vector<std::unique_ptr<FilterValues>> filters;
  for (const char* name : {"db4", "db8", "db9", "db10", "db12", "coif2", "coif4", "sym8"}) {
    filters.push_back(std::make_unique<FilterValues>(find_table_filter(name)));
    rows += rows_of(name, print_rules(taps_of(*filters.back()))[0], 14);
  }
  rows = replaced(rows, "db8,h,2,0.67563073629728", "db8,h,2,0.67563073629722");
  const CheckedTable table = check(rows);
  ASSERT_EQ(table.habits.size(), 1U);
  EXPECT_EQ(table.habits[0].exceptions, std::vector<std::string>{"db8 h_2"});
  EXPECT_EQ(table.habits[0].matched, table.habits[0].of - 1);
}

TEST(FindRoutes, CreditsNoHabitThatChanceExplains) {
  // All eight are cut off, and that has a probability of 2^-8 if they were rounded this way or that.
  const CheckedTable table = check(
      "D8,h,0,0.23037\nD8,h,1,0.71484\nD8,h,2,0.63088\nD8,h,3,-0.02798\nD8,h,4,-0.18703\n"
      "D8,h,5,0.03084\nD8,h,6,0.03288\nD8,h,7,-0.01059\n");
  EXPECT_FALSE(table.columns[0].credited);
  EXPECT_FALSE(table.counts().contains(PrintVerdict::published_route));
  EXPECT_NE(table.rows[0].detail.find("cut off"), std::string::npos)
      << "what is true of a single entry is said: " << table.rows[0].detail;
}

TEST(FindRoutes, CallsNothingCutOffThatIsNot) {
  // Each nine units too large.
  const CheckedTable table = check(
      "D4,h,0,0.4829629131445350\nD4,h,1,0.8365163037378088\nD4,h,2,0.2241438680420143\n"
      "D4,h,3,-0.1294095225512613\n");
  for (const CheckedRow& row : table.rows) {
    EXPECT_NE(row.verdict, PrintVerdict::published_route) << row.detail;
    EXPECT_NE(row.verdict, PrintVerdict::certified);
    EXPECT_EQ(row.detail.find("cut off"), std::string::npos);
    EXPECT_NEAR(row.ulps, 9, 0.5);
  }
}

TEST(FindRoutes, KnowsTheDecimalExpansionsOfDoubles) {
  FilterValues values(find_table_filter("db6"));
  const std::string rows = rows_of("db6", print_rules(taps_of(values))[1], 25);
  const CheckedTable table = check(rows);
  EXPECT_EQ(table.columns[0].route, "the nearest doubles");
  EXPECT_EQ(table.columns[0].matched, 12);
}

TEST(FindRoutes, MeasuresAtThePrintsOwnLastDigit) {
  // One decimal more than the column has, and wrong there: no route yields that.
  FilterValues values(find_table_filter("coif2"));
  const Route single = print_rules(taps_of(values))[2];
  std::string rows = rows_of("coif2", single, 12);
  const std::string right = round_to_decimals(single.value(4), 12)->text();
  rows = replaced(rows, right + "\n", right + "7\n");
  const CheckedTable table = check(rows);
  EXPECT_EQ(table.columns[0].route, "the nearest single-precision numbers");
  EXPECT_EQ(table.columns[0].matched, 11);
  EXPECT_NE(table.rows[4].verdict, PrintVerdict::published_route);
}

TEST(FindRoutes, FindsAPublishedTableDividedByItsNorm) {
  FilterValues values(find_table_filter("coif4"));
  RouteInput input;
  input.taps = taps_of(values);
  input.published_taps = find_published_taps("coif4");
  const std::string wanted =
      "the taps of " + input.published_taps->name + ", divided by their norm";
  for (const Route& route : run_routes(Quantity::taps, input)) {
    if (route.name != wanted) continue;
    const CheckedTable table = check(rows_of("coif4", route, 16));
    EXPECT_EQ(table.columns[0].route, wanted);
    EXPECT_EQ(table.counts(), (std::map<PrintVerdict, int>{{PrintVerdict::published_route, 24}}));
    return;
  }
  FAIL() << "no such route";
}

TEST(FindRoutes, FindsTheRouteThatATableWasMadeBy) {
  FilterValues values(find_table_filter("db5"));
  RouteInput input;
  input.taps = taps_of(values);
  input.decimals = 9;
  const std::string wanted =
      "alpha from h*sqrt2 rounded to 6 decimals; mu the eigenvector for the eigenvalue nearest "
      "zero";
  std::string rows;
  for (const Route& route : run_routes(Quantity::mu_normalized, input)) {
    if (route.name != wanted) continue;
    for (int l = 0; l < route.doubles.size(); ++l) {
      char text[40];
      std::snprintf(text, sizeof text, "%.9f", route.doubles[l]);
      rows += "db5,mu/mu0," + std::to_string(l) + "," + text + "\n";
    }
  }
  const CheckedTable table = check(rows);
  EXPECT_EQ(table.columns[0].route, wanted);
  EXPECT_EQ(table.columns[0].matched, table.columns[0].of);
  EXPECT_GE(table.counts().at(PrintVerdict::published_route), 2);
}

}  // namespace
}  // namespace wavecurve::verification
