#include "wavecurve/certified/diagnostics.hpp"

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"

namespace wavecurve::certified {
namespace {

TEST(RieszBounds, OfAnOrthonormalFamilyAreOne) {
  const auto bounds = riesz_bounds(find_filter("sym4"));
  ASSERT_TRUE(bounds.has_value());
  EXPECT_TRUE(bounds->lower == Ball(1) && bounds->upper == Ball(1));
}

TEST(RieszBounds, OfSplinesAreTheEulerFrobeniusValues) {
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

TEST(Symmetry, IsTold) {
  EXPECT_EQ(symmetry(find_filter("db4").bank(128).synthesis_low), Symmetry::none);
  const auto haar = find_filter("haar").bank(128);
  EXPECT_EQ(symmetry(haar.synthesis_low), Symmetry::symmetric);
  EXPECT_EQ(symmetry(haar.synthesis_high), Symmetry::antisymmetric);
}

TEST(WaveletSupport, OfDaubechiesHasTheLengthOfPhi) {
  const auto [first, last] = wavelet_support(find_filter("db4").bank(128));
  EXPECT_EQ(first, -3.0);
  EXPECT_EQ(last, 4.0);
}

}  // namespace
}  // namespace wavecurve::certified
