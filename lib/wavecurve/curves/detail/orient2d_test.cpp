#include "wavecurve/curves/detail/orient2d.hpp"

#include <cmath>
#include <limits>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve {
namespace {

using boost::multiprecision::cpp_rational;
using Eigen::Vector2d;

/// By exact fractions, from the definition.
int exact_sign(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const cpp_rational ax(a.x()), ay(a.y()), bx(b.x()), by(b.y()), cx(c.x()), cy(c.y());
  return cpp_rational((ax - cx) * (by - cy) - (ay - cy) * (bx - cx)).sign();
}

TEST(Orient2d, TurnsClockwiseWithYDown) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {1, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {1, -1}), -1);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {3, 3}), 0);
}

// Points a few units in the last place off a line: the rounded determinant is mostly zero or wrong.
TEST(Orient2d, IsExactBesideALine) {
  const double u = std::numeric_limits<double>::epsilon() / 2;
  for (int i = 0; i < 32; ++i) {
    for (int j = 0; j < 32; ++j) {
      const Vector2d a(0.5 + i * u, 0.5 + j * u), b(12, 12), c(24, 24);
      EXPECT_EQ(orient2d(a, b, c), exact_sign(a, b, c)) << i << ", " << j;
      EXPECT_EQ(orient2d(b, c, a), exact_sign(a, b, c)) << i << ", " << j;
    }
  }
}

RC_GTEST_PROP(Orient2d, EqualsExactFractionsNearALine, ()) {
  // A point of the line through two random ones, rounded, of very different magnitudes.
  const auto number = [] { return *rc::gen::inRange(-1000000, 1000000) / 997.0; };
  const Vector2d a(number(), number() * 1e-9), b(number() * 1e7, number());
  const double share = number();
  const Vector2d c = a + share * (b - a);
  RC_ASSERT(orient2d(a, b, c) == exact_sign(a, b, c));
}

}  // namespace
}  // namespace wavecurve
