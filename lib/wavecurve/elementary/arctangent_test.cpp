#include "wavecurve/elementary/arctangent.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "wavecurve/elementary/detail/elementary_tables.hpp"
#include "wavecurve/elementary/units_test.hpp"

namespace wavecurve {
namespace {

using certified::Ball;
constexpr double infinity = std::numeric_limits<double>::infinity();

Ball true_angle(double y, double x) {
  Ball result;
  arb_atan2(result.get(), Ball::from_double(y).get(), Ball::from_double(x).get(), 256);
  return result;
}

TEST(Arctangent, IsWithinTheProvedBound) {
  const certified::WorkingPrecision precision(256);
  double largest = 0;
  const auto try_at = [&](double y, double x) {
    // Below, the quotient is subnormal, and rounds by half a unit and no more.
    largest = std::max(largest, units_from(arctangent(y, x), true_angle(y, x)));
  };
  const std::vector<double> near = numbers_of_all_sizes(40001, -3, 3);
  const std::vector<double> wide = numbers_of_all_sizes(20001, -600, 600);
  for (std::size_t i = 0; i + 1 < near.size(); ++i) {
    try_at(near[i], near[i + 1]);
    try_at(-near[i], near[i + 1]);
  }
  for (std::size_t i = 0; i + 1 < wide.size(); ++i) try_at(wide[i], -wide[i + 1]);
  for (int j = 1; j < 64; ++j) {  // where the table turns to the next row
    for (const double q : {j / 64.0, std::nextafter(j / 64.0, 0)}) {
      for (const double sign : {1.0, -1.0}) {
        try_at(q, sign);
        try_at(1, sign * q);
        try_at(q * 0x1p-1060, sign * 0x1p-1060);
        try_at(q * 0x1p1023, sign * 0x1p1023);
      }
    }
  }
  EXPECT_LE(largest, elementary::arctangent_bound);
  RecordProperty("units", std::to_string(largest));
}

TEST(Arctangent, FollowsTheStandardForSpecialValues) {
  for (const double y : {0.0, 1.0, 0x1p-1074, 1e308, infinity}) {
    for (const double x : {0.0, 1.0, 0x1p-1074, 1e308, infinity}) {
      for (const double up : {y, -y}) {
        for (const double across : {x, -x}) {
          EXPECT_EQ(bits_of({arctangent(up, across)}), bits_of({std::atan2(up, across)}))
              << up << ' ' << across;
        }
      }
    }
  }
  EXPECT_TRUE(std::isnan(arctangent(std::nan(""), 1)) && std::isnan(arctangent(1, std::nan(""))));
}

TEST(Arctangent, GivesArccosine) {
  const certified::WorkingPrecision precision(256);
  for (const double x : numbers_of_all_sizes(10000, -30, 0)) {
    Ball truth;
    arb_acos(truth.get(), Ball::from_double(x).get(), 256);
    // Three roundings below the root, which halves them, and its own are 5/4 units of the sine at
    // most, by which the angle errs no more, relative to itself; its own bound is added.
    ASSERT_LE(units_from(arccosine(x), truth), 2) << x;
  }
  EXPECT_EQ(arccosine(1), 0);
  EXPECT_EQ(arccosine(-1), arctangent(0, -1));
  EXPECT_TRUE(std::isnan(arccosine(1.5)));
}

TEST(Arctangent, HasTheTangentAsInverse) {
  const certified::WorkingPrecision precision(256);
  for (const double x : numbers_of_all_sizes(10000, -10, 10)) {
    const Ball angle = Ball::from_double(x);
    ASSERT_LE(units_from(tangent(x), sin(angle) / cos(angle)), 5) << x;
  }
}

}  // namespace
}  // namespace wavecurve
