#include "wavecurve/elementary/logarithm.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "wavecurve/elementary/detail/elementary_tables.hpp"
#include "wavecurve/elementary/units_test.hpp"

namespace wavecurve {
namespace {

using certified::Ball;
constexpr double infinity = std::numeric_limits<double>::infinity();

double error_at(double x) { return units_from(logarithm(x), log(Ball::from_double(x))); }

TEST(Logarithm, IsWithinTheProvedBound) {
  const certified::WorkingPrecision precision(200);
  double largest = 0;
  for (const double x : numbers_of_all_sizes(20000, -1074, 1024)) {
    largest = std::max(largest, error_at(std::abs(x)));
  }
  for (const double x : numbers_of_all_sizes(40000, -52, 1)) {
    if (1 + x > 0 && x + 1 != 1) largest = std::max(largest, error_at(1 + x));
  }
  for (int k = -3; k < 4; ++k) {  // where the reduction turns to the next power of two
    for (const double m : {11.0 / 16, std::nextafter(11.0 / 16, 0), 11.0 / 8}) {
      largest = std::max(largest, error_at(std::ldexp(m, k)));
    }
  }
  EXPECT_LE(largest, elementary::logarithm_bound);
  RecordProperty("units", std::to_string(largest));
}

TEST(Logarithm, FollowsTheStandardForSpecialValues) {
  EXPECT_EQ(bits_of({logarithm(1), logarithm(0.0), logarithm(-0.0), logarithm(infinity)}),
            bits_of({0.0, -infinity, -infinity, infinity}));
  EXPECT_TRUE(std::isnan(logarithm(-1)));
  EXPECT_TRUE(std::isnan(logarithm(std::nan(""))));
}

TEST(Logarithm, ToTheBaseTenIsWholeForPowersOfTen) {
  const certified::WorkingPrecision precision(200);
  double power = 1;
  for (int n = 0; n <= 22; ++n, power *= 10) {
    EXPECT_EQ(logarithm_10(power), n);
    EXPECT_NE(logarithm_10(std::nextafter(power, infinity)), n == 0 ? 0 : n + 1);
  }
  for (const double x : numbers_of_all_sizes(10000, -1074, 1024)) {
    const Ball truth = log(Ball::from_double(std::abs(x))) / log(Ball(10));
    // The logarithm's unit may be two of the quotient's; ln(10) and the quotient round.
    ASSERT_LE(units_from(logarithm_10(std::abs(x)), truth), 3) << x;
  }
}

}  // namespace
}  // namespace wavecurve
