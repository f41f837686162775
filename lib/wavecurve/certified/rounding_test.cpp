#include "wavecurve/certified/rounding.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::certified {
namespace {

Rational random_rational() {
  const long numerator = *rc::gen::inRange<long>(-1000000000, 1000000000);
  const long denominator = *rc::gen::inRange<long>(1, 1000000);
  return {numerator, denominator};
}

TEST(Rounding, TiesGoToTheEvenDigit) {
  EXPECT_EQ(round_to_decimals(Rational(1, 8), 2), "0.12");
  EXPECT_EQ(round_to_decimals(Rational(3, 8), 2), "0.38");
  EXPECT_EQ(round_to_decimals(Rational(-1, 8), 2), "-0.12");
  EXPECT_EQ(round_to_decimals(Rational(5, 2), 0), "2");
}

TEST(Rounding, KeepsZerosAndDropsTheSignOfZero) {
  EXPECT_EQ(round_to_decimals(Rational(2), 3), "2.000");
  EXPECT_EQ(round_to_decimals(Rational(-1, 1000), 2), "0.00");
  EXPECT_EQ(round_to_decimals(Ball(Rational(-1, 3)), 0), "0");
}

TEST(Rounding, CarriesIntoANewDigit) {
  EXPECT_EQ(round_to_digits(Rational(9996, 10000), 3), "1.00");
  EXPECT_EQ(round_to_digits(Rational(99999, 1000), 2), "100");
  EXPECT_EQ(round_to_digits(Rational(1, 1000000), 3), "1.00e-6");
  EXPECT_EQ(round_to_digits(Rational(-1, 3), 5), "-0.33333");
}

TEST(Rounding, SaysNothingWhereTheEnclosureStraddlesABoundary) {
  const Rational boundary(1235, 10000);
  const Rational radius = Rational::power_of_two(-60);
  EXPECT_FALSE(round_to_decimals(Ball::around(boundary, radius), 3).has_value());
  EXPECT_EQ(round_to_decimals(Ball::around(boundary + radius + radius, radius), 3), "0.124");
  const Rational between = Rational(1) + Rational::power_of_two(-53);
  EXPECT_FALSE(round_to_double(Ball::around(between, radius)).has_value());
  EXPECT_EQ(round_to_double(Ball::around(Rational(1), radius)), 1.0);
}

TEST(Rounding, LooksAtBothEndsOfAnEnclosure) {
  // Ties that rounding to even takes up and down: one end decides otherwise than the middle.
  const Rational radius = Rational::power_of_two(-40);
  EXPECT_FALSE(round_to_decimals(Ball::around(Rational(3, 8), radius), 2).has_value());
  EXPECT_FALSE(round_to_decimals(Ball::around(Rational(1, 8), radius), 2).has_value());
  EXPECT_EQ(magnitude_bound(Ball::around(Rational(1), Rational(3, 2))), "3e0");
  EXPECT_EQ(magnitude_bound(Ball::around(Rational(-1), Rational(3, 2))), "3e0");
}

TEST(Rounding, RefusesAnInfiniteEnclosureAndNegativeCounts) {
  EXPECT_THROW(round_to_decimals(Ball(1) / Ball(0), 3), std::domain_error);
  EXPECT_THROW(round_to_decimals(Rational(1), -1), std::invalid_argument);
  EXPECT_THROW(round_to_digits(Rational(1), 0), std::invalid_argument);
}

TEST(Rounding, FloatIsRoundedOnceNotTwice) {
  // Just above a tie between two floats, but nearer than half an ulp of double to it: rounding to
  // double first would land on the tie and then go down to the even float.
  const Rational tie = Rational(1) + Rational::power_of_two(-24);
  const Rational x = tie + Rational::power_of_two(-60);
  const WorkingPrecision precision(128);
  EXPECT_EQ(round_to_float(Ball(x)), std::nextafter(1.0F, 2.0F));
  EXPECT_EQ(static_cast<float>(*round_to_double(Ball(x))), 1.0F);
}

TEST(Rounding, MagnitudeBoundIsAnUpperBoundOfOneDigit) {
  EXPECT_EQ(magnitude_bound(Ball(0)), "0");
  EXPECT_EQ(magnitude_bound(Ball(Rational(-21, 1000))), "3e-2");
  EXPECT_EQ(magnitude_bound(Ball(Rational(95, 10))), "1e1");
}

RC_GTEST_PROP(Rounding, StaysWithinHalfAUnit, ()) {
  const Rational x = random_rational();
  const int decimals = *rc::gen::inRange(0, 20);
  const Rational printed = Rational::from_decimal(round_to_decimals(x, decimals));
  const Rational unit = Rational::from_decimal("1e-" + std::to_string(decimals));
  RC_ASSERT((x - printed).abs() * Rational(2) <= unit);
}

RC_GTEST_PROP(Rounding, SignificantDigitsStayWithinHalfAUnitRelatively, ()) {
  const Rational x = random_rational();
  RC_PRE(!x.is_zero());
  const int digits = *rc::gen::inRange(1, 30);
  const Rational printed = Rational::from_decimal(round_to_digits(x, digits));
  const Rational relative = Rational::from_decimal("1e-" + std::to_string(digits - 1));
  RC_ASSERT((x - printed).abs() * Rational(2) <= relative * x.abs());
}

RC_GTEST_PROP(Rounding, BallAndRationalAgree, ()) {
  const Rational x = random_rational();
  const WorkingPrecision precision(256);
  const auto from_ball = round_to_decimals(Ball(x), 12);
  // A tie is the only number whose rounding an enclosure cannot decide at this precision.
  if (from_ball) RC_ASSERT(*from_ball == round_to_decimals(x, 12));
}

TEST(Rational, ReadsDecimalsExactly) {
  EXPECT_EQ(Rational::from_decimal("-0.25"), Rational(-1, 4));
  EXPECT_EQ(Rational::from_decimal("+1.5e-3"), Rational(3, 2000));
  EXPECT_EQ(Rational::from_decimal("2E2"), Rational(200));
  EXPECT_EQ(Rational::from_decimal(".5"), Rational(1, 2));
  for (const char* bad : {"", "-", ".", "1.2.3", "abc", "1e", "1e99999999", "0x10", "nan", "1 "}) {
    EXPECT_THROW(Rational::from_decimal(bad), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace wavecurve::certified
