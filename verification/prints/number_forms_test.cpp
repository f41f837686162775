#include "verification/prints/number_forms.hpp"

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

TEST(NumberForms, BringsTypesettingToAscii) {
  EXPECT_EQ(plain_number_text("-0.25e-7"), "-0.25e-7");
  EXPECT_EQ(plain_number_text(" \u22120.25\u00A0"), "-0.25");
  EXPECT_EQ(plain_number_text("5.3\u2009\u00D7\u200910\u207B\u00B9\u2070"), "5.3 * 10^-10");
  EXPECT_EQ(plain_number_text("$-5.3\\times 10^{-3}$"), "-5.3* 10^-3");
  EXPECT_EQ(plain_number_text("\\dfrac{75}{64}"), "75/64");
  EXPECT_EQ(plain_number_text("\\phantom{-}1\u2044"
                              "2"),
            "1/2");
  EXPECT_EQ(plain_number_text("3\u00BD"), "3 1/2") << "not 31/2";
  EXPECT_EQ(plain_number_text("1\u2019000"), "1'000");
}

TEST(NumberForms, LeavesWhatItDoesNotKnow) {
  EXPECT_EQ(plain_number_text("\\alpha"), "\\alpha");
  EXPECT_EQ(plain_number_text("\\phantom{1"), "\\phantom1");
  EXPECT_EQ(plain_number_text("\xE2\x88"), "\xE2\x88");
}

}  // namespace
}  // namespace wavecurve::verification
