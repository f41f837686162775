#include "verification/prints/column_errors.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

const PrintError right;

PrintError off_by(double absolute, double relative) { return {absolute, relative, true}; }

TEST(ColumnErrors, MeasuresAbsolutelyAndRelatively) {
  const TrueValue value{certified::Rational(1, 4), {}}, zero{certified::Rational(0), {}};
  const PrintError error = error_of(value, parse_printed_number("0.251"), true);
  EXPECT_NEAR(error.absolute, -3, 1e-12);
  EXPECT_NEAR(error.relative, std::log10(0.004), 1e-12);
  EXPECT_TRUE(error.inaccurate);
  EXPECT_EQ(error_of(zero, parse_printed_number("1e-17"), true).relative,
            -std::numeric_limits<double>::infinity());
  EXPECT_NEAR(error_of(zero, parse_printed_number("1e-390"), true).absolute, -390, 1e-9);
}

TEST(ColumnErrors, AreUsualIfAQuarterOfTheOthersIsAsFarOff) {
  const PrintError own{-6, -5, false};
  const auto is_usual = [&](std::vector<PrintError> others) {
    others.insert(others.begin() + 1, own);
    return ColumnErrors(others).are_usual_as(own);
  };
  EXPECT_FALSE(is_usual({right, right, right, right}));
  EXPECT_TRUE(is_usual({off_by(-6.9, -9), right, right, right}));
  EXPECT_TRUE(is_usual({off_by(-9, -5.9), right, right, right}));
  EXPECT_FALSE(is_usual({off_by(-6.9, -9), right, right, right, right}));
  EXPECT_FALSE(is_usual({off_by(-7.1, -6.1), off_by(-8, -8), off_by(-9, -9)}));
  EXPECT_FALSE(is_usual({{-6, -5, false}, {-3, -2, false}})) << "explained by edits";
}

TEST(ColumnErrors, SayNothingOfAnEntryThatStandsAlone) {
  const std::vector<PrintError> alone{{-6, -5, true}};
  EXPECT_FALSE(ColumnErrors(alone).are_usual_as(alone[0]));
}

}  // namespace
}  // namespace wavecurve::verification
