#include "verification/tables/true_value.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

using certified::Ball;
using certified::Rational;

TEST(TrueValue, RaisesThePrecisionUntilTheRoundingIsDecided) {
  long asked = 0;
  // 1/3 known to `bits` bits, less 300 bits that are lost.
  const TrueValue third{std::nullopt, [&asked](long bits) {
                          asked = bits;
                          return Ball::around(Rational(1, 3), Rational::power_of_two(300 - bits));
                        }};
  EXPECT_EQ(round_to_decimals(third, 5)->text(), "0.33333");
  EXPECT_EQ(asked, 512);
  EXPECT_EQ(is_within(third, Rational(1, 3), Rational(1, 1000)), Decision::yes);
  EXPECT_EQ(is_within(third, Rational(1, 2), Rational(1, 1000)), Decision::no);
}

TEST(TrueValue, StaysUndecidedOnATieThatIsNotKnownExactly) {
  const TrueValue half{std::nullopt, [](long bits) {
                         return Ball::around(Rational(1, 2), Rational::power_of_two(-bits));
                       }};
  EXPECT_EQ(round_to_decimals(half, 0), std::nullopt);
  EXPECT_EQ(is_within(half, Rational(0), Rational(1, 2)), Decision::undecided);
  const TrueValue exact_half{Rational(1, 2), {}};
  EXPECT_EQ(is_within(exact_half, Rational(0), Rational(1, 2)), Decision::yes);
}

}  // namespace
}  // namespace wavecurve::verification
