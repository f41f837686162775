#include "verification/prints/printed_number.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

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

TEST(PrintedNumber, GivesTheNearestDouble) {
  EXPECT_EQ(parse_printed_number("0.1").to_double(), 0.1);
  EXPECT_EQ(parse_printed_number("-1.2d-7").to_double(), -1.2e-7);
  EXPECT_EQ(parse_printed_number("9007199254740993").to_double(), 9007199254740992.0);
  EXPECT_EQ(parse_printed_number("1/3").to_double(), 1.0 / 3);
  EXPECT_EQ(parse_printed_number("1e-400").to_double(), 0);
  EXPECT_EQ(parse_printed_number("-1e400").to_double(), -std::numeric_limits<double>::infinity());
}

TEST(PrintedNumber, TellsABareZeroFromAZeroWithDecimals) {
  EXPECT_TRUE(parse_printed_number("0").is_bare_zero());
  EXPECT_TRUE(parse_printed_number("000").is_bare_zero());
  for (const char* text : {"0.0", "-0", "0e0", "0/1"}) {
    EXPECT_TRUE(parse_printed_number(text).is_zero()) << text;
    EXPECT_FALSE(parse_printed_number(text).is_bare_zero()) << text;
  }
  EXPECT_EQ(parse_printed_number("0.000e0").significant_digits(), 4);
}

void expect_number(const std::string& text, const std::string& plain) {
  try {
    EXPECT_EQ(parse_printed_number(text).text(), plain) << text;
  } catch (const std::invalid_argument& error) {
    ADD_FAILURE() << text << ": " << error.what();
  }
}

TEST(PrintedNumber, TakesExponentsInEveryNotation) {
  for (const char* text : {"5.3e-3",
                           "5.3E-03",
                           "5.3d-3",
                           "5.3D-03",
                           "5.3q-3",
                           "5.3e\u22123",
                           "5.3*10^-3",
                           "5.3 * 10^-3",
                           "5.3*10**-3",
                           "5.3x10^-3",
                           "5.3\u00D710^{-3}",
                           "5.3 \u00D7 10^(-3)",
                           "5.3\u00B710\u207B\u00B3",
                           "5.3*^-3",
                           "5.3(-3)",
                           "5.3 (\u22123)",
                           "5.3 e-3",
                           "5.3-003",
                           "$5.3\\times 10^{-3}$",
                           "$5.3\\cdot10^{-3}$",
                           "\\num{5.3e-3}",
                           "5.3e-3_dp",
                           "5.3e-3L"}) {
    expect_number(text, "5.3e-3");
  }
  expect_number("5.26d0", "5.26e0");
  expect_number("5.26D+00", "5.26e0");
  expect_number("5.26(0)", "5.26e0");
  expect_number("5.26(+2)", "5.26e2");
  expect_number("\u22125.26+103", "-5.26e103");
}

TEST(PrintedNumber, TakesDashesForSigns) {
  for (const char* text : {"-0.5", "\u22120.5", "\u20130.5", "\u20140.5", "\u20110.5", "\uFF0D0.5",
                           "- 0.5", "\u2212\u20090.5", "{-}0.5", "$-0.5$", "$-\\,0.5$"}) {
    expect_number(text, "-0.5");
  }
  expect_number("+0.5", "0.5");
  expect_number("\\phantom{-}0.5", "0.5");
  expect_number("\u00A00.5\u2009", "0.5");
}

TEST(PrintedNumber, TakesGroupsOfDigits) {
  for (const char* text :
       {"5.267 857", "5.267\u2009857", "5.267\u202F857", "5.267\u00A0857", "5.267_857", "5.267'857",
        "5.267\u2019857", "5.267\\,857", "5.267~857"}) {
    expect_number(text, "5.267857");
  }
  expect_number("0.23037 78133 08", "0.230377813308");
  expect_number("12 345.678 9", "12345.6789");
  expect_number("1'234'567", "1234567");
  expect_number("0.123 456e-7", "0.123456e-7");
  // A point in the middle of groups that are none, and two kinds of them.
  for (const char* text : {"1 2", "5.2 678", "12 34.5", "1234 567.0", "0 123.5", "5.267 85 7",
                           "5.267_857 142", "5.267 8571"}) {
    EXPECT_THROW(parse_printed_number(text), std::invalid_argument) << text;
  }
}

TEST(PrintedNumber, TakesTheSuffixesOfLiterals) {
  for (const char* text : {"0.34f", "0.34F", "0.34l", "0.34L", "0.34d", "0.34q", "0.34Q", "0.34f32",
                           "0.34_dp", "0.34_real64", "0.34_8", "0.34_16", "0.34`", "0.34`15.95"}) {
    expect_number(text, "0.34");
  }
  EXPECT_THROW(parse_printed_number("0.345_8"), std::invalid_argument) << "a group or a kind";
  EXPECT_THROW(parse_printed_number("0.34m"), std::invalid_argument);
  EXPECT_THROW(parse_printed_number("0.34_"), std::invalid_argument);
}

TEST(PrintedNumber, TakesFractionsAsExactValues) {
  for (const char* text : {"75/64", "75 / 64", "+75/64", "75./64.", "75.0/64", "7.5d1/6.4d1",
                           "075/064", "\\frac{75}{64}", "$\\tfrac{75}{64}$", "75\u204464"}) {
    expect_number(text, "75/64");
    EXPECT_EQ(parse_printed_number(text).value(), Rational(75, 64)) << text;
  }
  const PrintedNumber half = parse_printed_number("\u2212\u00BD");
  EXPECT_TRUE(half.is_fraction());
  EXPECT_EQ(half.value(), Rational(-1, 2));
  EXPECT_EQ(half.unit(), Rational(0));
  EXPECT_EQ(parse_printed_number("1e3/4").value(), Rational(250));
  for (const char* text : {"1/0", "1/0.0", "1.5/2", "1/-2", "1/2/3", "/2", "1/", "1\u00BD"}) {
    EXPECT_THROW(parse_printed_number(text), std::invalid_argument) << text;
  }
}

TEST(PrintedNumber, TakesAnyNumberOfLeadingZeros) {
  const std::string zeros(100000, '0');
  expect_number(zeros + "5.25", "5.25");
  expect_number("-" + zeros, "-0");
  expect_number(zeros + "1/" + zeros + "2", "1/2");
  const std::string many(400, '0');
  EXPECT_EQ(parse_printed_number("0." + many + "1").decimals(), 401);
  EXPECT_EQ(parse_printed_number("0." + many).decimals(), 400);
  EXPECT_THROW(parse_printed_number("0." + many + "00"), std::invalid_argument);
}

TEST(PrintedNumber, TakesADecimalCommaWhereItIsAllowed) {
  EXPECT_EQ(parse_printed_number("-5,26e-3", DecimalMark::comma).text(), "-5.26e-3");
  EXPECT_EQ(parse_printed_number("5.26", DecimalMark::comma).text(), "5.26");
  for (const char* text : {"1.234,5", "1,234,567", "1,234.5"}) {
    EXPECT_THROW(parse_printed_number(text, DecimalMark::comma), std::invalid_argument) << text;
  }
}

TEST(PrintedNumber, RefusesWhatIsNoNumber) {
  for (const char* text : {"",
                           "-",
                           ".",
                           "e5",
                           "1e",
                           "1e+",
                           "1e5.0",
                           "1.2.3",
                           "1,5",
                           "0x1p3",
                           "nan",
                           "inf",
                           "1 2",
                           "--1",
                           "+-1",
                           "1e999",
                           "1e-99999999999",
                           "5.3*11^-3",
                           "5.3*10",
                           "5.3*10^",
                           "5.3x",
                           "10^",
                           "5.3(3)",
                           "5.3(-3",
                           "5.3()",
                           "5.3-03",
                           "1-2",
                           "\u00D710^3",
                           "\u207B5",
                           "5.3\u00B3",
                           "$",
                           "{}",
                           "\\frac{1}{}",
                           "\\phantom{1",
                           "1ff",
                           "1fx",
                           "\xE2\x88",
                           "\xFF"
                           "1",
                           "1 ."}) {
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

/// Whatever the bytes: a number that reads back as itself, or a short printable refusal.
void expect_number_or_refusal(const std::string& text, DecimalMark mark) {
  try {
    const PrintedNumber number = parse_printed_number(text, mark);
    RC_ASSERT(parse_printed_number(number.text()) == number);
    number.value();
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    RC_ASSERT(message.size() < 120U);
    RC_ASSERT(
        std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c <= '~'; }));
  }
}

RC_GTEST_PROP(PrintedNumber, EveryTextIsANumberOrARefusal, ()) {
  const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "0", "1", "57", "123", ".", ",", "-", "+", "e", "D", "*", "10", "^", "(", ")", "/", " ", "_",
      "'", "`", "f", "x", "{", "}", "}{", "$", "\\", "\\frac", "\\times", "\\,", "\\phantom{",
      "\u2212", "\u2009", "\u00D7", "\u00B3", "\u00BD", "\xE2", "\xFF", std::string(1, '\0'),
      "999999999999", std::string(300, '0'), std::string(300, '7')));
  std::string text;
  for (const std::string& piece : pieces) text += piece;
  const DecimalMark mark = *rc::gen::element(DecimalMark::point, DecimalMark::comma);
  expect_number_or_refusal(text, mark);
  expect_number_or_refusal(*rc::gen::string<std::string>(), mark);
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
