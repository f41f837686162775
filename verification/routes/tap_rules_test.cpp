#include "verification/routes/tap_rules.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "verification/quantities/filter_values.hpp"
#include "verification/routes/print_rules.hpp"

namespace wavecurve::verification {
namespace {

using certified::Ball;
using certified::Rational;

RouteInput input_for(FilterValues& values) {
  RouteInput input;
  for (int i = 0; i < values.number_of_taps(); ++i) {
    input.taps.push_back(values.value(Quantity::taps, values.first_tap() + i));
  }
  input.orthonormal = values.is_orthonormal();
  return input;
}

const Route& find(const std::vector<Route>& routes, const std::string& name) {
  const auto found = std::find_if(routes.begin(), routes.end(),
                                  [&](const Route& route) { return route.name == name; });
  if (found == routes.end()) throw std::invalid_argument("no route is called " + name);
  return *found;
}

Ball enclosure(const TrueValue& value) {
  return value.exact ? Ball(*value.exact) : value.enclosure(256);
}

TEST(TapRules, RoundTheTapsInTheNormalizationNamed) {
  FilterValues values(find_table_filter("D8"));
  const auto routes = tap_rules(Quantity::taps_sum_1, input_for(values));
  const Route& route = find(routes, "h/sqrt2 rounded to 8 decimals");
  EXPECT_FALSE(route.rounding_errors) << "a rule has no rounding errors";
  for (std::size_t n = 0; n < 8; ++n) {
    const auto rounded =
        round_to_decimals(values.value(Quantity::taps_sum_1, static_cast<int>(n)), 8);
    ASSERT_TRUE(route.value(n).exact);
    EXPECT_EQ(*route.value(n).exact, rounded->value());
  }
}

TEST(TapRules, DivideByTheSumAndByTheNorm) {
  const certified::WorkingPrecision precision(256);
  FilterValues values(find_table_filter("coif2"));
  for (const Quantity& column : {Quantity::taps, Quantity::taps_sum_2, Quantity::taps_sum_1}) {
    const auto routes = tap_rules(column, input_for(values));
    Ball sum, squares;
    for (std::size_t n = 0; n < 12; ++n) {
      sum += enclosure(find(routes, "h rounded to 7 decimals, divided by their sum").value(n));
      const Ball tap =
          enclosure(find(routes, "h*sqrt2 rounded to 7 decimals, divided by their norm").value(n));
      squares += tap * tap;
    }
    const Rational square = column == Quantity::taps ? 2 : column == Quantity::taps_sum_2 ? 4 : 1;
    EXPECT_TRUE((sum * sum).contains(square)) << to_string(column);
    EXPECT_TRUE((squares * Ball(2)).contains(square)) << to_string(column);
    EXPECT_LT((sum * sum).radius_double(), 1e-60);
  }
}

/// What a program does in double precision.
Eigen::VectorXd computed(const Route& table, const std::string& words) {
  const Eigen::VectorXd& g = table.doubles;
  if (words == ", divided by their sum") return g * (std::numbers::sqrt2 / g.sum());
  if (words == ", divided by their norm") return g / std::sqrt(g.squaredNorm());
  return g * std::numbers::sqrt2;
}

TEST(TapRules, BoundTheErrorsOfDoubleArithmetic) {
  for (const char* filter : {"db2", "db7", "db20", "sym11", "coif5"}) {
    FilterValues values(find_table_filter(filter));
    const RouteInput input = input_for(values);
    const auto decimals = tap_rules(Quantity::taps_sum_1, input);
    const auto routes = tap_rules(Quantity::taps, input);
    for (const std::string words : {"", ", divided by their sum", ", divided by their norm"}) {
      const std::string name = "h/sqrt2 rounded to 12 decimals";
      const Eigen::VectorXd program = computed(find(decimals, name), words);
      const Route& route = find(routes, name + words + ", in double arithmetic");
      const Eigen::VectorXd bounds = route.rounding_errors();
      for (Eigen::Index n = 0; n < program.size(); ++n) {
        const Ball error = abs(Ball::from_double(program[n]) -
                               enclosure(route.value(static_cast<std::size_t>(n))));
        EXPECT_LE(error.to_double(), bounds[n]) << filter << words << " " << n;
        EXPECT_LT(bounds[n], 1e-14);
      }
    }
  }
}

TEST(TapRules, LeaveOutTheNormOfWhatHasNone) {
  FilterValues values(find_table_filter("bspline4.4"));
  for (const Route& route : tap_rules(Quantity::taps, input_for(values))) {
    EXPECT_EQ(route.name.find("norm"), std::string::npos) << route.name;
  }
}

TEST(PrintRules, NameTheNearestDoublesAndFloats) {
  FilterValues values(find_table_filter("coif1"));
  const auto rules = print_rules(input_for(values).taps);
  ASSERT_EQ(rules.size(), 3U);
  EXPECT_EQ(rules[0].printing, Printing::cut_off);
  for (std::size_t n = 0; n < 6; ++n) {
    const double tap = rules[0].doubles[static_cast<Eigen::Index>(n)];
    EXPECT_EQ(*rules[1].value(n).exact, *exactly(tap).exact);
    EXPECT_EQ(*rules[2].value(n).exact, *exactly(static_cast<float>(tap)).exact);
  }
}

}  // namespace
}  // namespace wavecurve::verification
