#include "verification/routes/column_routes.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

using certified::Rational;

/// A column of eight equal prints, each so many units away from its true value.
std::vector<EntryToExplain> column_of(const std::string& print, double distance) {
  const EntryToExplain entry{0, parse_printed_number(print), std::nullopt, distance > 0.5,
                             distance};
  return std::vector<EntryToExplain>(8, entry);
}

int matched(const Route& route, const std::string& print) {
  return score_routes(column_of(print, 7), {route})[1].matched;
}

TEST(ColumnRoutes, ARuleYieldsExactlyWhatItRoundsTo) {
  const Rational tie = Rational::from_decimal("0.12345"), little = power_of_ten(-60);
  const auto numbers = [](const Rational& number) { return rule("r", {TrueValue{number, {}}}); };
  EXPECT_EQ(matched(numbers(tie + little), "0.1235"), 8);
  EXPECT_EQ(matched(numbers(tie + little), "0.1234"), 0) << "half a unit and 1e-56 away";
  EXPECT_EQ(matched(numbers(tie - little), "0.1234"), 8);
  EXPECT_EQ(matched(numbers(tie), "0.1234"), 8) << "either neighbour of a tie";
  EXPECT_EQ(matched(numbers(tie), "0.12345"), 8);
  EXPECT_EQ(matched(numbers(tie), "0.123451"), 0) << "one decimal more is measured there";
}

TEST(ColumnRoutes, ARuleThatCutsOffYieldsTheLeadingDigitsOnly) {
  const auto numbers = [](const std::string& number) {
    return rule("r", {TrueValue{Rational::from_decimal(number), {}}}, Printing::cut_off);
  };
  EXPECT_EQ(matched(numbers("-0.12349"), "-0.1234"), 8);
  EXPECT_EQ(matched(numbers("-0.12349"), "-0.1235"), 0);
  EXPECT_EQ(matched(numbers("-0.12340"), "-0.1234"), 8);
  EXPECT_EQ(matched(numbers("0"), "-0.0001"), 0);
}

TEST(ColumnRoutes, AllowAComputationAtMostHalfTheDistanceToTheTruth) {
  const auto score = [](double computed, double rounding_error) {
    Route route{"c", {"c"}, Printing::rounded, {}, {}, Eigen::VectorXd::Constant(1, computed), {}};
    route.rounding_errors = [rounding_error]() -> Eigen::VectorXd {
      return Eigen::VectorXd::Constant(1, rounding_error);
    };
    return score_routes(column_of("0.5000", 100), {route})[1];
  };
  EXPECT_EQ(score(0.5 + 49e-4, 1).matched, 8);
  EXPECT_EQ(score(0.5 + 49e-4, 1).allowance, 50);
  EXPECT_EQ(score(0.5 + 52e-4, 1).matched, 0) << "nearer to the true value than to the print";
  EXPECT_EQ(score(0.5 + 49e-4, 30e-4).matched, 0) << "the bound is less";
  EXPECT_EQ(score(0.5 + 0.4e-4, 1).allowance, 0) << "none is needed";
  EXPECT_EQ(score(0.5, 1).trials, 2);
  EXPECT_LT(score(0.5, 1).chance, score(0.5 + 49e-4, 1).chance);
}

}  // namespace
}  // namespace wavecurve::verification
