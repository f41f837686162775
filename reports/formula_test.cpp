#include "reports/formula.hpp"

#include <string>

#include <gtest/gtest.h>

namespace wavecurve::reports {
namespace {

TEST(Formula, SetsIndicesAndExponents) {
  EXPECT_EQ(formula_html("c_n^{M_f} + 1"), "c<sub>n</sub><sup>M<sub>f</sub></sup> + 1");
  EXPECT_EQ(formula_html("C^-1 ρ^2"), "C<sup>-1</sup> ρ<sup>2</sup>");
  EXPECT_EQ(formula_html("like N^1.14."), "like N<sup>1.14</sup>.");
  EXPECT_EQ(formula_html("10^-12, (a + b)^2, |x|_F, K_ij"),
            "10<sup>-12</sup>, (a + b)<sup>2</sup>, |x|<sub>F</sub>, K<sub>ij</sub>");
  EXPECT_EQ(formula_html("Σ_n μ_l"), "Σ<sub>n</sub> μ<sub>l</sub>");
}

TEST(Formula, LeavesNamesAndLooseEndsAlone) {
  for (const char* text : {"own_value", "table_1.csv", "a_", "a_ b", "_x", "^2", "a_{b", "x^-", "",
                           "__", "a__b", "0 _ 1", "snake_case_name"}) {
    EXPECT_EQ(formula_html(text), text);
  }
}

TEST(Formula, EscapesEverything) {
  EXPECT_EQ(formula_html("a_{<b>} & c_i < d"), "a<sub>&lt;b&gt;</sub> &amp; c<sub>i</sub> &lt; d");
}

TEST(Formula, IsSetInUnicodeWhereThatHasTheCharacters) {
  EXPECT_EQ(formula_text("s_1 = 2, C^-1, x_{n-1} < 10^-12"), "s₁ = 2, C⁻¹, xₙ₋₁ < 10⁻¹²");
  EXPECT_EQ(formula_text("M_f, own_value, N^1.14, a_"), "M_f, own_value, N^1.14, a_");
}

}  // namespace
}  // namespace wavecurve::reports
