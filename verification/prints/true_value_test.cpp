#include "verification/prints/true_value.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "verification/quantities/filter_values.hpp"

namespace wavecurve::verification {
namespace {

using certified::Ball;
using certified::Rational;

TEST(TrueValue, RaisesThePrecisionUntilTheRoundingIsDecided) {
  long asked = 0;
  // 1/3 known to `bits` bits, less 300 bits that are lost.
  const TrueValue third{std::nullopt, [&asked](long bits) {
                          asked = bits;
                          return Ball::around(Rational(1, 3), Rational::power_of_two(300 - bits));
                        }};
  EXPECT_EQ(round_to_decimals(third, 5)->text(), "0.33333");
  EXPECT_EQ(asked, 512);
  EXPECT_EQ(is_within(third, Rational(1, 3), Rational(1, 1000)), Decision::yes);
  EXPECT_EQ(is_within(third, Rational(1, 2), Rational(1, 1000)), Decision::no);
}

TEST(TrueValue, IsCutOffTowardZeroAtTheLastDigitOnly) {
  FilterValues d4(find_table_filter("db2"));  // 0.48296291314453414..., -0.12940952255126038...
  const auto is = [&d4](int tap, const std::string& print) {
    const PrintedNumber number = parse_printed_number(print);
    return is_cut_off(d4.value(Quantity::taps, tap), number.value(), number.decimals());
  };
  EXPECT_EQ(is(0, "0.4829629131445"), Decision::yes);
  EXPECT_EQ(is(0, "0.48296291314453"), Decision::yes);
  EXPECT_EQ(is(0, "0.4829629131445342"), Decision::no) << "rounded up";
  EXPECT_EQ(is(0, "0.4829629131445341"), Decision::yes);
  EXPECT_EQ(is(0, "0.4829629131445340"), Decision::no) << "a unit too small";
  EXPECT_EQ(is(0, "0.4829629131445350"), Decision::no) << "nine units too large";
  EXPECT_EQ(is(3, "-0.1294"), Decision::yes);
  EXPECT_EQ(is(3, "-0.1295"), Decision::no) << "away from zero";
  EXPECT_EQ(is(3, "0.1294"), Decision::no) << "another sign";
  EXPECT_EQ(is(3, "0"), Decision::yes);
  EXPECT_EQ(is(0, "4.8e-1"), Decision::yes);
}

TEST(TrueValue, AnExactZeroCutOffIsZero) {
  const TrueValue zero{Rational(0), {}}, quarter{Rational(-1, 4), {}};
  const auto is = [](const TrueValue& value, const std::string& print) {
    const PrintedNumber number = parse_printed_number(print);
    return is_cut_off(value, number.value(), number.decimals());
  };
  EXPECT_EQ(is(zero, "0.000"), Decision::yes);
  EXPECT_EQ(is(zero, "-5.07923307e-17"), Decision::no);
  EXPECT_EQ(is(zero, "0.0000000000000001"), Decision::no);
  EXPECT_EQ(is(quarter, "-0.2"), Decision::yes);
  EXPECT_EQ(is(quarter, "-0.25"), Decision::yes);
  EXPECT_EQ(is(quarter, "-0.24"), Decision::no);
  EXPECT_EQ(is(quarter, "0.25"), Decision::no);
}

TEST(TrueValue, TimesARootIsExactWhereItCanBe) {
  const TrueValue third{Rational(1, 3), {}};
  EXPECT_EQ(*times_root(third, Rational(4, 9)).exact, Rational(2, 9));
  const TrueValue irrational = times_root(third, Rational(2));
  EXPECT_FALSE(irrational.exact);
  EXPECT_EQ(round_to_decimals(irrational, 20)->text(), "0.47140452079103168293");
  EXPECT_EQ(round_to_decimals(times_root(irrational, Rational(2)), 10)->text(), "0.6666666667");
}

TEST(TrueValue, IsApproximatedToTwiceADouble) {
  FilterValues d4(find_table_filter("db2"));
  const TrueValue tap = d4.value(Quantity::taps, 0);
  const Approximation near = approximate(tap);
  EXPECT_LT(near.error, 1e-29);
  const auto at = [&](const std::string& text) {
    return apart(near, approximate({parse_printed_number(text).value(), {}}));
  };
  EXPECT_LT(at("0.48296291314453414337487159986445"), 1e-29);
  EXPECT_NEAR(at("0.48296291314453414337487160086445"), 1e-27, 2e-30);
  EXPECT_EQ(*exactly(0.1).exact - Rational(1, 10), Rational(1, 10) * Rational::power_of_two(-54));
}

TEST(TrueValue, StaysUndecidedOnATieThatIsNotKnownExactly) {
  const TrueValue half{std::nullopt, [](long bits) {
                         return Ball::around(Rational(1, 2), Rational::power_of_two(-bits));
                       }};
  EXPECT_EQ(round_to_decimals(half, 0), std::nullopt);
  EXPECT_EQ(is_within(half, Rational(0), Rational(1, 2)), Decision::undecided);
  const TrueValue exact_half{Rational(1, 2), {}};
  EXPECT_EQ(is_within(exact_half, Rational(0), Rational(1, 2)), Decision::yes);
}

}  // namespace
}  // namespace wavecurve::verification
