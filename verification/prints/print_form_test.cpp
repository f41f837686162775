#include "verification/prints/print_form.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

ColumnForm form_of_column(const std::vector<std::string>& texts) {
  std::vector<PrintedNumber> prints;
  for (const std::string& text : texts) prints.push_back(parse_printed_number(text));
  return column_form(prints);
}

TrueValue exactly(const std::string& decimal) {
  return {certified::Rational::from_decimal(decimal), {}};
}

TEST(ColumnForm, IsTheMostCommonOne) {
  EXPECT_EQ(form_of_column({"0.25", "0.5", "1.00", "0", "0", "0"}).form, (PrintForm{false, 2}));
  EXPECT_EQ(form_of_column({"0.25", "0.5", "1.00"}).fixed, (PrintForm{false, 2}));
  EXPECT_EQ(form_of_column({"1.25e-3", "1.5e2", "1.75e1"}).form, (PrintForm{true, 3}));
}

TEST(ColumnForm, TakesTheLongestOfEquallyCommonOnes) {
  EXPECT_EQ(form_of_column({"0.25", "0.5"}).form.digits, 2);
  EXPECT_EQ(form_of_column({"0.5", "0.25"}).form.digits, 2);
}

TEST(ColumnForm, IsNoHabitOfASinglePrintOrOfBareZeros) {
  EXPECT_FALSE(form_of_column({"0.25"}).fixed);
  EXPECT_FALSE(form_of_column({"0", "0"}).fixed);
  EXPECT_FALSE(form_of_column({"1/4", "1/4"}).fixed);
}

TEST(ColumnForm, HasAHabitForEachNotation) {
  const ColumnForm mixed =
      form_of_column({"0.2304", "0.7148", "-0.0106", "1.25e-5", "1.5e-6", "-2.75e-7"});
  EXPECT_EQ(mixed.fixed, (PrintForm{false, 4}));
  EXPECT_EQ(mixed.scientific, (PrintForm{true, 3}));
  EXPECT_EQ(mixed.habit(parse_printed_number("0.1")), (PrintForm{false, 4}));
  EXPECT_EQ(mixed.habit(parse_printed_number("1e-1")), (PrintForm{true, 3}));
  EXPECT_FALSE(mixed.habit(parse_printed_number("1/4")));
}

TEST(ColumnForm, HasNoHabitWithoutAMajority) {
  EXPECT_FALSE(form_of_column({"0.25", "0.75", "0.5", "0.1", "0.125"}).fixed);
  // "%.4g": four significant digits are the habit, not so many decimals.
  EXPECT_FALSE(form_of_column({"0.2304", "0.7148", "0.6309", "-0.02798", "0.03084"}).fixed);
}

TEST(PrintForm, RoundsInTheFormOfThePrint) {
  EXPECT_EQ(round_to_form(exactly("-0.0012346"), {false, 5})->text(), "-0.00123");
  EXPECT_EQ(round_to_form(exactly("-0.0012346"), {true, 4})->text(), "-1.235e-3");
  EXPECT_EQ(round_to_form(exactly("99996"), {true, 4})->text(), "1.000e5");
  EXPECT_EQ(round_to_form(exactly("0"), {true, 4})->value(), certified::Rational(0));
}

TEST(PrintForm, CountsCorrectDigits) {
  const TrueValue value = exactly("0.634202334430");
  const auto count = [&](const char* text) {
    return correct_digits(value, parse_printed_number(text));
  };
  EXPECT_EQ(count("0.634202334430"), 12);
  EXPECT_EQ(count("0.6342"), 4);
  EXPECT_EQ(count("0.634202334000"), 9);
  EXPECT_EQ(count("0.634202334431"), 11);
  EXPECT_EQ(count("0.634802334430"), 3);
  EXPECT_EQ(count("-0.634202334430"), 0);
  EXPECT_EQ(count("6.34"), 0);
  EXPECT_EQ(count("0"), 0);
  EXPECT_EQ(correct_digits(exactly("0.4000001"), parse_printed_number("0.3999999")), 6);
  EXPECT_EQ(correct_digits(exactly("0.4001"), parse_printed_number("0.3999")), 3);
  EXPECT_EQ(correct_digits(exactly("0"), parse_printed_number("0.1")), 0);
}

TEST(PrintForm, CountsTheCorrectDigitsOfAFraction) {
  const TrueValue pi = exactly("3.14159265358979");
  EXPECT_EQ(correct_digits(pi, parse_printed_number("22/7")), 3);
  EXPECT_EQ(correct_digits(pi, parse_printed_number("3550000/1130000")), 7);
  EXPECT_EQ(correct_digits(exactly("1.171875"), parse_printed_number("75/64")), 4);
}

TEST(PrintForm, FindsTheNumberBeforeThePadding) {
  const auto shorter = [](const char* value, const char* print) {
    const auto found = without_padding(exactly(value), parse_printed_number(print));
    return found ? found->text() : "";
  };
  EXPECT_EQ(shorter("0.59619180291743835", "0.5961918029174380"), "0.596191802917438");
  EXPECT_EQ(shorter("1.09501654270807123", "1.0950165427080700"), "1.09501654270807");
  EXPECT_EQ(shorter("-0.00123456", "-1.23000e-3"), "-1.23e-3");
  EXPECT_EQ(shorter("-0.00123356", "-1.23400e-3"), "-1.234e-3");
  EXPECT_EQ(shorter("0.1234", "0.12300"), "0.123");
  EXPECT_EQ(shorter("0.1239", "0.12300"), "") << "cut off, not rounded";
  EXPECT_EQ(shorter("0.1249", "0.1200"), "") << "two digits are left";
  EXPECT_EQ(shorter("123.4", "120"), "") << "no zeros behind the point";
  EXPECT_EQ(shorter("0.0001", "0.000"), "");
}

TEST(PrintForm, LaysTheIntendedPrintsOutAsThePrint) {
  const auto intended = [](const char* value, const char* print) {
    const PrintedNumber number = parse_printed_number(print);
    return intended_prints(exactly(value), number, column_form({number, number})).at(0).text();
  };
  EXPECT_EQ(intended("0.0040976", "-0.4097e-2"), "0.4098e-2");
  EXPECT_EQ(intended("0.0040976", "41.97e-4"), "40.98e-4");
  EXPECT_EQ(intended("0.0040976", "4.1e-3"), "4.1e-3");
  EXPECT_EQ(intended("0.0040976", "0.0042"), "0.0041");
}

TEST(PrintForm, MeasuresTheDistanceInUnitsOfTheLastDigit) {
  EXPECT_EQ(distance_in_units(exactly("0.25"), parse_printed_number("0.31")), 6);
  EXPECT_EQ(distance_in_units(exactly("0.25"), parse_printed_number("3.1e-1")), 6);
  EXPECT_EQ(distance_in_units(exactly("0.25"), parse_printed_number("0.250")), 0);
  EXPECT_TRUE(std::isnan(distance_in_units(exactly("0.25"), parse_printed_number("1/3"))));
  const std::string thirds(150, '3');  // more digits than the first precision tried holds
  const TrueValue third{std::nullopt, [](long bits) {
                          return certified::Ball::around(certified::Rational(1, 3),
                                                         certified::Rational::power_of_two(-bits));
                        }};
  EXPECT_NEAR(distance_in_units(third, parse_printed_number("0." + thirds)), 1.0 / 3, 1e-9);
}

TEST(PrintForm, FindsWhereAPrintDeparts) {
  const auto from = [](const char* print, const char* right) {
    return departure(parse_printed_number(print), parse_printed_number(right));
  };
  const auto digit = [](std::size_t index) { return Departure{false, index}; };
  EXPECT_EQ(from("-0.632970245318", "-0.632970245425"), digit(10));
  EXPECT_EQ(from("0.000061489440", "0.000061489441"), digit(12));
  EXPECT_EQ(from("1.200356164723", "1.200356164721"), digit(12));
  EXPECT_EQ(from("0.00001267", "0.00000127"), digit(5)) << "a dropped zero moves all that follow";
  EXPECT_EQ(from("2.5", "12.5"), digit(0)) << "a lost digit before the first";
  EXPECT_EQ(from("12.5", "2.5"), digit(0));
  EXPECT_EQ(from("0.4097e-2", "0.004095"), digit(4)) << "the places count, not the notation";
  EXPECT_EQ(from("1.27e7", "1.25e7"), digit(2));
  EXPECT_EQ(from("0.25", "0.25"), Departure{});
  EXPECT_EQ(from("0.25", "-0.25"), (Departure{true, std::nullopt}));
  EXPECT_EQ(from("-0.25", "0.26"), (Departure{true, 2}));
  EXPECT_EQ(from("-0.00", "0.00"), Departure{}) << "a zero has no sign to lose";
  EXPECT_EQ(from("2/7", "0.25"), digit(0));
}

TEST(PrintForm, FindsWhereAPrintDepartsFromAValue) {
  const TrueValue third{certified::Rational(1) / certified::Rational(3), {}};
  const auto from = [&](const char* print) {
    return departure(third, parse_printed_number(print));
  };
  EXPECT_EQ(from("0.33343"), (Departure{false, 4}));
  EXPECT_EQ(from("3.3343e-1"), (Departure{false, 3}));
  EXPECT_EQ(from("-0.333"), (Departure{true, std::nullopt}));
  EXPECT_EQ(from("0"), (Departure{false, 0})) << "equal to the rounding, and wrong all the same";
}

}  // namespace
}  // namespace wavecurve::verification
