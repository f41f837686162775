#include "verification/identify/identify.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::verification {
namespace {

NumberList list_of(const std::vector<double>& values, int decimals) {
  NumberList list;
  for (const double value : values) {
    list.numbers.push_back(parse_printed_number(fmt::format("{:.{}f}", value, decimals)));
  }
  return list;
}

const KnownColumn& known(std::string_view filter, std::string_view quantity) {
  const auto& all = known_columns();
  return *std::find_if(all.begin(), all.end(), [&](const KnownColumn& column) {
    return column.filter == filter && to_string(column.quantity) == quantity;
  });
}

bool names(const std::vector<Match>& matches, const KnownColumn& column) {
  return std::any_of(matches.begin(), matches.end(), [&](const Match& match) {
    return match.matched == matches.front().matched && match.column->filter == column.filter;
  });
}

RC_GTEST_PROP(Identify, FindsAColumnInAnyOrderSignAndFactor, ()) {
  const auto& all = known_columns();
  const KnownColumn& column = all[*rc::gen::inRange<std::size_t>(0, all.size())];
  std::vector<double> values = column.values.taps;
  const auto last =
      std::find_if(values.rbegin(), values.rend(), [](double v) { return std::abs(v) > 1e-4; });
  RC_PRE(values.rend() - last >= 4);  // a shorter one is in too many
  if (*rc::gen::arbitrary<bool>()) std::reverse(values.begin(), values.end());
  const double factor =
      std::pow(std::sqrt(2.0), *rc::gen::inRange(-2, 3)) * (*rc::gen::arbitrary<bool>() ? -1 : 1);
  for (double& value : values) value *= factor;
  const auto matches = identify(list_of(values, *rc::gen::inRange(9, 16)));
  RC_ASSERT(!matches.empty());
  RC_ASSERT(matches.front().matched == matches.front().of);
  RC_ASSERT(names(matches, column));
}

TEST(Identify, FindsAPartAndALooseOrder) {
  const KnownColumn& column = known("db6", "h");
  std::vector<double> part(column.values.taps.begin() + 2, column.values.taps.begin() + 8);
  EXPECT_TRUE(names(identify(list_of(part, 12)), column));
  EXPECT_EQ(identify(list_of(part, 12)).front().convention.shift, 2);
  std::swap(part[0], part[4]);
  const auto loose = identify(list_of(part, 12));
  ASSERT_FALSE(loose.empty());
  EXPECT_EQ(loose.front().column->filter, "db6");
}

TEST(Identify, NumbersBelowTheirOwnDecimalsDoNotHideIt) {
  const KnownColumn& column = known("db6", "phi");  // its last value is 4e-9
  for (const int decimals : {9, 10, 12}) {
    EXPECT_TRUE(names(identify(list_of(column.values.taps, decimals)), column)) << decimals;
  }
}

TEST(Identify, OneMisprintDoesNotHideIt) {
  const KnownColumn& column = known("coif2", "h");
  std::vector<double> values = column.values.taps;
  values[6] += 0.1;
  const auto matches = identify(list_of(values, 12));
  ASSERT_FALSE(matches.empty());
  EXPECT_EQ(matches.front().column->filter, "coif2");
  EXPECT_EQ(matches.front().matched, 11);
}

TEST(Identify, AnyFactorIsFoundByTheLargestEntry) {
  std::vector<double> values = known("sym5", "h").values.taps;
  for (double& value : values) value *= 1.2345;
  const auto matches = identify(list_of(values, 12));
  ASSERT_FALSE(matches.empty());
  EXPECT_FALSE(matches.front().scale_is_power);
  EXPECT_NEAR(std::abs(matches.front().scale), 1.2345, 1e-9);
}

TEST(Identify, WhatIsNothingHasOnlyNeighbours) {
  EXPECT_TRUE(identify(list_of({1, 2, 3}, 0)).empty());
  EXPECT_TRUE(identify(list_of({0.123, 0.456, 0.789, -0.321}, 3)).empty());
  EXPECT_TRUE(identify(list_of({0, 0, 0}, 3)).empty());
  EXPECT_EQ(nearest_columns(list_of({1, 2, 3}, 0), {}).size(), 3u);
}

TEST(Identify, ScalesAreNamed) {
  Match match;
  const auto text = [&](int half_powers) {
    match.convention.half_powers = half_powers;
    return scale_text(match);
  };
  EXPECT_EQ(text(0), "1");
  EXPECT_EQ(text(1), "sqrt2");
  EXPECT_EQ(text(-1), "1/sqrt2");
  EXPECT_EQ(text(2), "2");
  EXPECT_EQ(text(-2), "1/2");
  EXPECT_EQ(text(-3), "1/(2*sqrt2)");
}

}  // namespace
}  // namespace wavecurve::verification
