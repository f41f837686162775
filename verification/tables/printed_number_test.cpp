#include "verification/tables/printed_number.hpp"

#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::verification {
namespace {

using certified::Rational;

TEST(PrintedNumber, KnowsEveryDigitOfAFixedPrint) {
  const PrintedNumber number = parse_printed_number("-0.01250");
  EXPECT_TRUE(number.negative);
  EXPECT_EQ(number.decimals(), 5);
  EXPECT_EQ(number.significant_digits(), 4);
  EXPECT_EQ(number.significand(), "1250");
  EXPECT_EQ(number.value(), Rational(-1, 80));
  EXPECT_EQ(number.unit(), Rational(1, 100000));
  EXPECT_EQ(number.text(), "-0.01250");
}

TEST(PrintedNumber, TakesTheUnitOfScientificNotationFromTheMantissaAndTheExponent) {
  const PrintedNumber number = parse_printed_number("1.25E-07");
  EXPECT_EQ(number.decimals(), 9);
  EXPECT_EQ(number.significant_digits(), 3);
  EXPECT_EQ(number.value(), Rational::from_decimal("0.000000125"));
  EXPECT_EQ(number.text(), "1.25e-7");
  EXPECT_EQ(parse_printed_number("12e3").decimals(), -3);
  EXPECT_EQ(parse_printed_number("12e3").unit(), Rational(1000));
}

TEST(PrintedNumber, TakesWhatTypesettersPrint) {
  EXPECT_EQ(parse_printed_number(".5").text(), "0.5");
  EXPECT_EQ(parse_printed_number("+3").value(), Rational(3));
  EXPECT_EQ(parse_printed_number("\xE2\x88\x92"
                                 "0.5")
                .value(),
            Rational(-1, 2));
  EXPECT_EQ(parse_printed_number("3.").decimals(), 0);
}

TEST(PrintedNumber, TellsABareZeroFromAZeroWithDecimals) {
  EXPECT_TRUE(parse_printed_number("0").is_bare_zero());
  for (const char* text : {"0.0", "-0", "0e0", "00"}) {
    EXPECT_TRUE(parse_printed_number(text).is_zero()) << text;
    EXPECT_FALSE(parse_printed_number(text).is_bare_zero()) << text;
  }
  EXPECT_EQ(parse_printed_number("0.000e0").significant_digits(), 4);
}

TEST(PrintedNumber, RefusesWhatIsNoNumber) {
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "1e5.0", "1.2.3", "1,5", "0x1p3", "nan",
                           "inf", "1 2", "--1", "1e999", "1e-99999999999", "1.0f"}) {
    EXPECT_THROW(parse_printed_number(text), std::invalid_argument) << text;
  }
}

TEST(PrintedNumber, DoesNotRepeatALongText) {
  const std::string text(1000000, '7');
  try {
    parse_printed_number(text);
    FAIL() << "a number of a million digits was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_LT(std::string(error.what()).size(), 120U);
  }
}

RC_GTEST_PROP(PrintedNumber, TextAndValueGoThereAndBack, (int mantissa, bool scientific)) {
  const int decimals = *rc::gen::inRange(0, 30);
  const Rational unit = power_of_ten(-decimals);
  std::string digits = std::to_string(std::abs(static_cast<long>(mantissa)));
  digits.insert(0, std::string(static_cast<std::size_t>(decimals) + 1, '0'));
  digits.insert(digits.size() - static_cast<std::size_t>(decimals), ".");
  const std::string text = (mantissa < 0 ? "-" : "") + digits + (scientific ? "e-3" : "");
  const PrintedNumber number = parse_printed_number(text);
  RC_ASSERT(number.decimals() == decimals + (scientific ? 3 : 0));
  RC_ASSERT(number.value() == Rational(mantissa) * unit * power_of_ten(scientific ? -3 : 0));
  RC_ASSERT(parse_printed_number(number.text()) == number);
}

}  // namespace
}  // namespace wavecurve::verification
