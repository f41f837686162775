#include "wavecurve/elementary/sine_cosine.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/elementary/detail/elementary_tables.hpp"
#include "wavecurve/elementary/detail/every_target_test.hpp"
#include "wavecurve/elementary/detail/quarter_turns.hpp"
#include "wavecurve/elementary/units_test.hpp"

namespace wavecurve {
namespace {

using certified::Ball;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Errors {
  double sine = 0, cosine = 0;
};

/// Enough bits for the reduction of the largest double.
Errors errors_at(const std::vector<double>& angles) {
  const certified::WorkingPrecision precision(1300);
  Errors largest;
  for (const double x : angles) {
    const auto [s, c] = sine_cosine(x);
    if (x != 0) largest.sine = std::max(largest.sine, units_from(s, sin(Ball::from_double(x))));
    largest.cosine = std::max(largest.cosine, units_from(c, cos(Ball::from_double(x))));
  }
  return largest;
}

void expect_within_the_bounds(const std::vector<double>& angles) {
  const Errors errors = errors_at(angles);
  EXPECT_LE(errors.sine, std::max(elementary::sine_bound, elementary::cosine_bound));
  EXPECT_LE(errors.cosine, std::max(elementary::sine_bound, elementary::cosine_bound));
  testing::Test::RecordProperty("sine", std::to_string(errors.sine));
  testing::Test::RecordProperty("cosine", std::to_string(errors.cosine));
}

/// Doubles next to multiples of pi/4, where one of the two is nearly zero, or the reduction turns
/// to the next quarter.
std::vector<double> hard_angles() {
  std::vector<double> angles;
  for (int i = 0; i < 400; ++i) {
    const double multiple = i < 200 ? i : std::floor(std::pow(1.07, i));
    double x = multiple * std::numbers::pi / 4;
    for (int j = 0; j < 3; ++j) x = std::nextafter(x, 0);
    for (int j = 0; j < 6; ++j) {
      angles.push_back(x);
      angles.push_back(-x);
      x = std::nextafter(x, infinity);
    }
  }
  // No other double is nearer to a multiple of pi/2.
  angles.push_back(std::ldexp(6381956970095103.0, 797));
  for (const double x : {0x1p20, 0x1p1023, 0x1p-1074, 0x1p-1022, 0x1p-30, 1e22}) {
    for (const double near : {std::nextafter(x, 0), x, std::nextafter(x, infinity)}) {
      angles.push_back(near);
    }
  }
  angles.push_back(std::numeric_limits<double>::max());
  return angles;
}

TEST(SineCosine, AreWithinTheProvedBoundWhereTheyAreHard) {
  expect_within_the_bounds(hard_angles());
}

TEST(SineCosine, AreWithinTheProvedBoundAtNumbersOfAllSizes) {
  expect_within_the_bounds(numbers_of_all_sizes(40000, -3, 21));
  expect_within_the_bounds(numbers_of_all_sizes(10000, -1070, 1024));
}

TEST(SineCosine, FollowTheStandardForSpecialValues) {
  EXPECT_EQ(bits_of({sine(0.0), sine(-0.0), cosine(0.0), cosine(-0.0)}),
            bits_of({0.0, -0.0, 1.0, 1.0}));
  EXPECT_EQ(sine(0x1p-1074), 0x1p-1074);
  for (const double x : {infinity, -infinity, std::nan("")}) {
    EXPECT_TRUE(std::isnan(sine(x)) && std::isnan(cosine(x)));
  }
}

TEST(SineCosine, BothReductionsAgree) {
  // Each is exact to 2^-63 of the angle, and is the sum of two doubles.
  for (const double x : numbers_of_all_sizes(20000, -9, 20)) {
    const auto direct = elementary::quarter_turns(x);
    const auto whole = elementary::quarter_turns_in_whole_numbers(x);
    const double size = std::abs(direct.angle);
    ASSERT_EQ(direct.quarters % 4, whole.quarters % 4) << x;
    const double difference = (direct.angle - whole.angle) + (direct.low - whole.low);
    ASSERT_LE(std::abs(difference), std::ldexp(size, -62)) << x;
  }
}

/// All results of arrays of every length up to several vectors, from every place in a vector on,
/// with what takes the other reduction among them.
std::vector<double> results_of_arrays() {
  std::vector<double> angles = numbers_of_all_sizes(2000, -6, 22);
  const std::vector<double> hard = hard_angles();
  angles.insert(angles.end(), hard.begin(), hard.end());
  angles.insert(angles.end(), {0.0, -0.0, infinity, std::nan(""), -infinity});
  std::vector<double> results;
  const auto append = [&](Eigen::Index first, Eigen::Index size) {
    const Eigen::Map<const Eigen::ArrayXd> x(angles.data() + first, size);
    Eigen::ArrayXd s(size), c = x;
    sine_cosine(c, s, c);
    results.insert(results.end(), s.data(), s.data() + size);
    results.insert(results.end(), c.data(), c.data() + size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const SineCosine twin = sine_cosine(x[i]);
      EXPECT_EQ(bits_of({s[i], c[i]}), bits_of({twin.sine, twin.cosine})) << x[i];
    }
  };
  for (Eigen::Index first = 0; first < 8; ++first) {
    for (Eigen::Index size = 0; size < 40; ++size) append(first, size);
  }
  append(0, static_cast<Eigen::Index>(angles.size()));
  return results;
}

TEST(SineCosine, HaveTheTwinsBitsForArraysOnEveryTarget) {
  expect_the_same_bits_on_every_target([] { return bits_of(results_of_arrays()); });
}

TEST(SineCosine, RefusesResultsOfAnotherSize) {
  Eigen::ArrayXd x(3), right(3), wrong(2);
  EXPECT_THROW(sine_cosine(x, wrong, right), std::invalid_argument);
  EXPECT_THROW(sine_cosine(x, right, wrong), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
