#include "verification/prints/judge_print.hpp"

#include <string>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

TrueValue exactly(const std::string& number) { return {parse_printed_number(number).value(), {}}; }

/// The square root of two, known by enclosures only.
TrueValue root_of_two() {
  return {std::nullopt, [](long bits) {
            const certified::WorkingPrecision precision(bits);
            return sqrt(certified::Ball(2));
          }};
}

JudgedPrint judged(const TrueValue& value, const std::string& text) {
  const PrintedNumber print = parse_printed_number(text);
  const JudgedPrint alone = judge_print(value, print, {});
  return alone.wrong ? judge_wrong_print(value, print, alone.repair) : alone;
}

void expect(const std::string& value, const std::string& print, PrintVerdict verdict,
            const std::string& detail) {
  const JudgedPrint result = judged(exactly(value), print);
  EXPECT_EQ(to_string(result.verdict), to_string(verdict)) << print << ": " << result.detail;
  EXPECT_EQ(result.detail, detail) << print;
}

TEST(JudgePrint, CertifiesAFractionThatIsTheValue) {
  expect("75/64", "75/64", PrintVerdict::certified, "exactly this fraction");
  expect("75/64", "150/128", PrintVerdict::certified, "exactly this fraction");
  expect("22/7", "355/113", PrintVerdict::agrees_to_digits,
         "3 significant digits right; a fraction is the value itself or is not");
  expect("2", "7/4", PrintVerdict::discrepant,
         "1 significant digit right; a fraction is the value itself or is not");
  EXPECT_EQ(judged(root_of_two(), "577/408").detail.substr(0, 26), "6 significant digits right");
  EXPECT_EQ(judged(root_of_two(), "577/408").verdict, PrintVerdict::agrees_to_digits);
}

TEST(JudgePrint, LeavesTheEqualityOfAFractionOpenWhereEnclosuresCannotTell) {
  const TrueValue two{std::nullopt, [](long bits) {
                        const certified::WorkingPrecision precision(bits);
                        return sqrt(certified::Ball(2)) * sqrt(certified::Ball(2));
                      }};
  EXPECT_EQ(judged(two, "4/2").verdict, PrintVerdict::undecided);
}

TEST(JudgePrint, SaysHowFarAPaddedPrintIsRight) {
  expect("0.59619180291743835", "0.5961918029174380", PrintVerdict::form,
         "right to 15 decimals (0.596191802917438), then filled up with 1 zero");
  expect("1.09501654270807123", "1.0950165427080700", PrintVerdict::form,
         "right to 14 decimals (1.09501654270807), then filled up with 2 zeros");
  expect("0.00123356", "1.23400e-3", PrintVerdict::form,
         "right to 4 significant digits (1.234e-3), then filled up with 2 zeros");
}

TEST(JudgePrint, MeasuresByTheDigitsThatArePrinted) {
  expect("5.2678571", "5.2", PrintVerdict::agrees_to_digits,
         "2 of 2 significant digits right; the true value cut off instead of rounded");
  expect("5.2678571", "6", PrintVerdict::agrees_to_digits,
         "1 of 1 significant digit right; off by less than one unit of its last digit");
  expect("5.2678571", "5.1", PrintVerdict::discrepant, "1 of 2 significant digits right");
  expect("5.2678571", "5.26785", PrintVerdict::agrees_to_digits,
         "6 of 6 significant digits right; the true value cut off instead of rounded");
  expect("5.2678571", "5.26111111", PrintVerdict::agrees_to_digits,
         "3 of 9 significant digits right");
  expect("0.0007", "0.000", PrintVerdict::agrees_to_digits,
         "0 of 4 significant digits right; the true value cut off instead of rounded");
  expect("0.7", "0", PrintVerdict::discrepant, "0 of 1 significant digit right");
  expect("0", "5.08e-17", PrintVerdict::discrepant, "the true value is exactly zero");
}

TEST(JudgePrint, TakesAWrongSignForAMisprintInEveryNotation) {
  expect("-0.0040976568934", "0.0040976568934", PrintVerdict::misprint,
         "a lost sign: -0.0040976568934");
  expect("-0.0040976568934", "0.40976568934e-2", PrintVerdict::misprint,
         "a lost sign: -0.40976568934e-2");
  expect("0.0220702918848", "-2.20702918848d-2", PrintVerdict::misprint,
         "an added sign: 2.20702918848e-2");
  expect("0.0220702918848", "-22.0702918848(-3)", PrintVerdict::misprint,
         "an added sign: 22.0702918848e-3");
  expect("0.02207029188484", "-0.0220702918849", PrintVerdict::misprint,
         "an added sign; but for it, 12 of 12 significant digits right");
  expect("0.0220702918848", "-0.0220712345678", PrintVerdict::discrepant,
         "an added sign; but for it, 5 of 12 significant digits right");
  expect("-0.3", "0.41", PrintVerdict::discrepant, "0 of 2 significant digits right");
}

TEST(JudgePrint, PrefersTheNeighbourOfTheRoundingToPadding) {
  expect("0.634202334431", "0.634202334430", PrintVerdict::agrees_to_digits,
         "11 of 12 significant digits right; one unit in the last digit is a rounding difference");
  expect("0.6342023344308", "0.634202334430", PrintVerdict::agrees_to_digits,
         "12 of 12 significant digits right; the true value cut off instead of rounded");
}

TEST(JudgePrint, ShowsAFractionBesideAFraction) {
  const auto shown = [](const TrueValue& value, const char* print) {
    const PrintedNumber number = parse_printed_number(print);
    return certified_text(value, number, column_form({parse_printed_number("0.25"), number}), true);
  };
  EXPECT_EQ(shown(exactly("75/64"), "74/64"), "75/64");
  EXPECT_EQ(shown(root_of_two(), "7/5"), "1.41");
  EXPECT_EQ(shown(root_of_two(), "1.5"), "1.4");
}

}  // namespace
}  // namespace wavecurve::verification
