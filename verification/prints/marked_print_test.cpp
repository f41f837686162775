#include "verification/prints/marked_print.hpp"

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

/// The text with brackets around what departs.
std::string marked(const std::string& text, const Departure& departure) {
  std::string result, whole;
  for (const PrintPart& part : marked_print(text, parse_printed_number(text), departure)) {
    result += part.departs ? "[" + part.text + "]" : part.text;
    whole += part.text;
  }
  EXPECT_EQ(whole, text) << "nothing is lost";
  return result;
}

std::string marked(const std::string& text, std::size_t digit) {
  return marked(text, Departure{false, digit});
}

constexpr Departure only_the_sign{true, std::nullopt};

TEST(MarkedPrint, MarksFromTheFirstWrongDigitOn) {
  EXPECT_EQ(marked("-0.632970245318", 10), "-0.632970245[318]");
  EXPECT_EQ(marked("0.25", 0), "[0.25]");
  EXPECT_EQ(marked("0.0025", 1), "0.[0025]") << "a zero that should be a digit";
}

TEST(MarkedPrint, LeavesDigitsThatAreKnownToBeRight) {
  EXPECT_EQ(marked("0.63188077", Departure{false, 3, 4}), "0.63[1]88077");
  EXPECT_EQ(marked(".63188077", Departure{false, 3, 5}), ".63[18]8077");
}

TEST(MarkedPrint, LeavesExponentsAndSuffixesAlone) {
  EXPECT_EQ(marked("1.25e-25", 2), "1.2[5]e-25");
  EXPECT_EQ(marked("1.25d+02", 2), "1.2[5]d+02");
  EXPECT_EQ(marked("0.34f32", 2), "0.3[4]f32");
  EXPECT_EQ(marked("$-1.25\\times10^{-7}$", 1), "$-1.[25]\\times10^{-7}$");
}

TEST(MarkedPrint, FindsTheDigitsInEveryNotation) {
  EXPECT_EQ(marked(".25", 2), ".2[5]") << "the zero before the point is not printed";
  EXPECT_EQ(marked(".25", 0), ".[25]");
  EXPECT_EQ(marked("007.25", 1), "007.[25]");
  EXPECT_EQ(marked("5.267 857", 3), "5.26[7 857]");
  EXPECT_EQ(marked("0.000", 2), "0.0[00]");
  EXPECT_EQ(marked("0", 0), "[0]");
  EXPECT_EQ(marked("3/4", 0), "[3/4]");
  EXPECT_EQ(marked("½", 0), "[½]");
}

TEST(MarkedPrint, MarksASignOrItsPlace) {
  EXPECT_EQ(marked("-0.25", only_the_sign), "[-]0.25");
  EXPECT_EQ(marked("−0.25", only_the_sign), "[−]0.25");
  EXPECT_EQ(marked("$-0.25$", only_the_sign), "$[-]0.25$");
  EXPECT_EQ(marked("0.25", only_the_sign), "[]0.25");
  EXPECT_EQ(marked("-0.25", Departure{true, 2}), "[-]0.2[5]");
}

TEST(MarkedPrint, LeavesARightPrintAlone) {
  const auto parts = marked_print("0.25", parse_printed_number("0.25"), std::nullopt);
  EXPECT_EQ(parts, (std::vector<PrintPart>{{"0.25", false}}));
}

}  // namespace
}  // namespace wavecurve::verification
