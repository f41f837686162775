#include "wavecurve/certified/diagnostics.hpp"

#include <string>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/user_filter.hpp"

namespace wavecurve::certified {
namespace {

TEST(RieszBounds, AreOneForAnOrthonormalFamily) {
  const auto bounds = riesz_bounds(find_filter("sym4"));
  ASSERT_TRUE(bounds.has_value());
  EXPECT_TRUE(bounds->lower == Ball(1) && bounds->upper == Ball(1));
}

TEST(RieszBounds, DoNotExistForOrthonormalTapsWithoutOrthonormalShifts) {
  // phi = 1/3 on [0, 3].
  EXPECT_FALSE(
      riesz_bounds(define_user_filter({"mine", {0, {"1", "0", "0", "1"}}, {}, "2", {}, {}})));
}

TEST(RieszBounds, AreTheEulerFrobeniusValuesForSplines) {
  // G(0) = 1; G(pi) = 1/3 for the linear, 2/15 for the quadratic, 17/315 for the cubic spline.
  const std::pair<const char*, Rational> known[] = {{"bspline2.2", Rational(1, 3)},
                                                    {"bspline3.3", Rational(2, 15)},
                                                    {"bspline4.4", Rational(17, 315)}};
  for (const auto& [name, lower] : known) {
    const auto bounds = riesz_bounds(find_filter(name));
    ASSERT_TRUE(bounds.has_value()) << name;
    EXPECT_TRUE(bounds->lower.contains(lower)) << name;
    EXPECT_TRUE(bounds->upper.contains(Rational(1))) << name;
    EXPECT_LT(bounds->lower.radius_double(), 1e-10);
  }
}

TEST(RieszBounds, AreFoundInsideTheInterval) {
  // The Gram symbol of this dual is 1 at 0, 10/9 at pi and largest between them: 9/8 at 2 pi / 3.
  const auto bounds = riesz_bounds(dual(find_filter("bspline1.3")));
  ASSERT_TRUE(bounds.has_value());
  EXPECT_TRUE(bounds->lower.contains(Rational(1)));
  EXPECT_TRUE(bounds->upper.contains(Rational(9, 8)));
  EXPECT_LT(bounds->upper.radius_double(), 1e-9);
}

TEST(RieszBounds, DoNotExistForADualThatIsNoFunction) {
  EXPECT_FALSE(riesz_bounds(dual(find_filter("bspline3.1"))).has_value());
}

// The minimum of the Gram symbol of these was looked for without end: the taps are known worse than
// the width that was aimed at.
TEST(RieszBounds, AreAsNarrowAsTheTapsAllow) {
  UserFilter rough{"mine", {-1, {"0.353553", "0.707107", "0.353553"}}};
  rough.dual = {-2, {"-0.176777", "0.353553", "1.060660", "0.353553", "-0.176777"}};
  for (const char* accuracy : {"", "1e-5", "1e-4", "1e-3", "1e-2"}) {
    if (*accuracy != 0) rough.accuracy = accuracy;
    const auto definition = define_user_filter(rough);
    const auto bounds = riesz_bounds(definition);
    if (!bounds) {
      EXPECT_STREQ(accuracy, "1e-2");
      continue;
    }
    EXPECT_TRUE(bounds->lower.contains(Rational(1, 3))) << accuracy;
    EXPECT_TRUE(bounds->upper.contains(Rational(1))) << accuracy;
    EXPECT_LT(bounds->lower.radius_double(), 50 * std::stod(*accuracy != 0 ? accuracy : "5e-7"));
  }
}

// The shifts of db3 are orthonormal, but the two sides do not say so, being printed with different
// digits: the symbol is 1, but for errors, and every part could hold its minimum.
TEST(RieszBounds, AreFoundInBoundedWorkForAFlatSymbol) {
  UserFilter db3{"mine", {0, {"0.33267", "0.80689", "0.45988", "-0.13501", "-0.08544", "0.03523"}}};
  db3.dual = {0, {"0.332671", "0.806892", "0.459878", "-0.135011", "-0.085441", "0.035226"}};
  const auto bounds = riesz_bounds(define_user_filter(db3));
  ASSERT_TRUE(bounds.has_value());
  EXPECT_TRUE(bounds->lower.contains(Rational(1)));
  EXPECT_TRUE(bounds->upper.contains(Rational(1)));
  EXPECT_LT(bounds->upper.radius_double(), 1e-2);
}

TEST(Symmetry, IsTold) {
  EXPECT_EQ(symmetry(find_filter("db4").bank(128).synthesis_low), Symmetry::none);
  const auto haar = find_filter("haar").bank(128);
  EXPECT_EQ(symmetry(haar.synthesis_low), Symmetry::symmetric);
  EXPECT_EQ(symmetry(haar.synthesis_high), Symmetry::antisymmetric);
}

TEST(WaveletSupport, HasTheLengthOfPhiForDaubechies) {
  const auto [first, last] = wavelet_support(find_filter("db4").bank(128));
  EXPECT_EQ(first, -3.0);
  EXPECT_EQ(last, 4.0);
}

}  // namespace
}  // namespace wavecurve::certified
