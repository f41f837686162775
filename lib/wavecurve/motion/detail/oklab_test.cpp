#include "wavecurve/motion/detail/oklab.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::motion {
namespace {

using Eigen::Vector3d;

Vector3d components(const Colour& colour) { return {colour.red, colour.green, colour.blue}; }

Colour any_colour() {
  const auto component = [] { return *rc::gen::inRange(0, 256) / 255.0; };
  return {component(), component(), component()};
}

// The matrices are printed with ten decimals and their rows sum to 1 or 0 to a few units of 1e-8.
TEST(Oklab, GreysHaveNoHue) {
  for (const double grey : {0.0, 0.2, 0.5, 1.0}) {
    const Vector3d lab = to_oklab({grey, grey, grey});
    EXPECT_NEAR(lab.y(), 0, 1e-6);
    EXPECT_NEAR(lab.z(), 0, 1e-6);
  }
  EXPECT_NEAR(to_oklab({1, 1, 1}).x(), 1, 1e-6);
}

// The values that Ottosson 2020 prints for XYZ and sRGB agree on the sign of a and b.
TEST(Oklab, HuesHaveTheirSides) {
  EXPECT_GT(to_oklab({1, 0, 0}).y(), 0.1);
  EXPECT_LT(to_oklab({0, 1, 0}).y(), -0.1);
  EXPECT_LT(to_oklab({0, 0, 1}).z(), -0.1);
  EXPECT_GT(to_oklab({1, 1, 0}).z(), 0.1);
}

// The two branches of the transfer function do not meet exactly: they differ by some 1e-8 there.
RC_GTEST_PROP(Oklab, IsInvertible, ()) {
  const Colour colour = any_colour();
  RC_ASSERT((components(from_oklab(to_oklab(colour))) - components(colour)).cwiseAbs().maxCoeff() <
            1e-7);
}

RC_GTEST_PROP(ColourLine, IsNearTheLineInOklab, ()) {
  const Colour from = any_colour(), to = any_colour();
  const auto stops = colour_line(from, to);
  RC_ASSERT(stops.front().share == 0 && stops.front().colour == from);
  RC_ASSERT(stops.back().share == 1 && stops.back().colour == to);
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    RC_ASSERT(stops[i].share < stops[i + 1].share);
    for (int k = 0; k <= 37; ++k) {
      const double inner = k / 37.0, share = std::lerp(stops[i].share, stops[i + 1].share, inner);
      const Colour exact = from_oklab((1 - share) * to_oklab(from) + share * to_oklab(to));
      const Vector3d chord =
          (1 - inner) * components(stops[i].colour) + inner * components(stops[i + 1].colour);
      RC_ASSERT((components(exact) - chord).cwiseAbs().maxCoeff() < 1.0 / 512);
    }
  }
}

TEST(ColourLine, HasTwoStopsForEqualColours) {
  EXPECT_EQ(colour_line({0.2, 0.4, 0.6}, {0.2, 0.4, 0.6}).size(), 2u);
}

}  // namespace
}  // namespace wavecurve::motion
