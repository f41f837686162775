#include "wavecurve/elementary/exponential.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/elementary/detail/elementary_tables.hpp"
#include "wavecurve/elementary/detail/every_target_test.hpp"
#include "wavecurve/elementary/units_test.hpp"

namespace wavecurve {
namespace {

using certified::Ball;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Next to the middles between multiples of log(2), where the reduction turns to the next one.
std::vector<double> hard_exponents() {
  std::vector<double> exponents;
  for (int k = -1021; k < 1023; ++k) {
    const double x = (k + 0.5) * std::numbers::ln2;
    exponents.insert(exponents.end(), {x, std::nextafter(x, 1000), std::nextafter(x, -1000)});
    exponents.push_back((k + 1) * std::numbers::ln2);
  }
  return exponents;
}

std::vector<double> exponents() {
  std::vector<double> x = numbers_of_all_sizes(60000, -60, 9);
  const std::vector<double> hard = hard_exponents();
  x.insert(x.end(), hard.begin(), hard.end());
  return x;
}

TEST(Exponential, IsWithinTheProvedBound) {
  const certified::WorkingPrecision precision(200);
  double largest = 0;
  for (const double x : exponents()) {
    largest = std::max(largest, units_from(exponential(x), exp(Ball::from_double(x))));
  }
  EXPECT_LE(largest, elementary::exponential_bound);
  RecordProperty("units", std::to_string(largest));
}

TEST(Exponential, RoundsSubnormalResultsOnceMore) {
  const certified::WorkingPrecision precision(200);
  for (int i = 0; i < 20000; ++i) {
    const double x = -708 - 37.1 * i / 20000;
    // The bound of a normal result, in units that are at most half as large, and half a unit.
    const double bound = x < -708.5 ? elementary::exponential_bound / 2 + 0.5 : 1;
    ASSERT_LE(units_from(exponential(x), exp(Ball::from_double(x))), bound) << x;
  }
}

TEST(Exponential, MinusOneIsWithinTheProvedBound) {
  const certified::WorkingPrecision precision(300);
  double largest = 0;
  for (const double x : exponents()) {
    largest =
        std::max(largest, units_from(exponential_minus_one(x), exp(Ball::from_double(x)) - 1));
  }
  EXPECT_LE(largest, elementary::exponential_minus_one_bound);
  EXPECT_EQ(bits_of({exponential_minus_one(-0.0), exponential_minus_one(-infinity),
                     exponential_minus_one(infinity), exponential_minus_one(0x1p-1074)}),
            bits_of({-0.0, -1.0, infinity, 0x1p-1074}));
  EXPECT_TRUE(std::isnan(exponential_minus_one(std::nan(""))));
  RecordProperty("units", std::to_string(largest));
}

TEST(Exponential, FollowsTheStandardForSpecialValues) {
  EXPECT_EQ(bits_of({exponential(0.0), exponential(-0.0), exponential(infinity),
                     exponential(-infinity), exponential(1e300), exponential(-1e300)}),
            bits_of({1.0, 1.0, infinity, 0.0, infinity, 0.0}));
  // The last exponents before infinity and before 0.
  EXPECT_TRUE(std::isfinite(exponential(0x1.62e42fefa39efp+9)));
  EXPECT_EQ(exponential(std::nextafter(0x1.62e42fefa39efp+9, 1000)), infinity);
  EXPECT_EQ(exponential(-0x1.74910d52d3051p+9), 0x1p-1074);
  EXPECT_EQ(exponential(std::nextafter(-0x1.74910d52d3051p+9, -1000)), 0);
  EXPECT_TRUE(std::isnan(exponential(std::nan(""))));
}

TEST(Exponential, AgreesForComplexNumbersAndTheirHyperbolicSine) {
  const certified::WorkingPrecision precision(200);
  const std::vector<double> parts = numbers_of_all_sizes(4000, -20, 6);
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const std::complex<double> z(parts[i], parts[i + 1]);
    const Ball x = Ball::from_double(z.real()), y = Ball::from_double(z.imag());
    const Ball e = exp(x), inverse = exp(-x);
    const std::complex<double> power = exponential(z), sinh = hyperbolic_sine(z);
    // A unit of a product's factor may be two of the product's, and the product rounds.
    ASSERT_LE(units_from(power.real(), e * cos(y)), 4) << z;
    ASSERT_LE(units_from(power.imag(), e * sin(y)), 4) << z;
    ASSERT_LE(units_from(sinh.real(), (e - inverse) / 2 * cos(y)), 8) << z;
    ASSERT_LE(units_from(sinh.imag(), (e + inverse) / 2 * sin(y)), 8) << z;
  }
}

std::vector<double> results_of_arrays() {
  std::vector<double> x = exponents();
  const std::vector<double> wide = numbers_of_all_sizes(2000, -1070, 1024);
  x.insert(x.end(), wide.begin(), wide.end());
  x.insert(x.end(), {0.0, -0.0, infinity, std::nan(""), -infinity, -740.0, -745.2, 709.9});
  std::vector<double> results;
  const auto append = [&](Eigen::Index first, Eigen::Index size) {
    Eigen::ArrayXd y = Eigen::Map<const Eigen::ArrayXd>(x.data() + first, size);
    exponential(y, y);
    results.insert(results.end(), y.data(), y.data() + size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const double at = x[static_cast<std::size_t>(first + i)];
      EXPECT_EQ(bits_of({y[i]}), bits_of({exponential(at)})) << at;
    }
  };
  for (Eigen::Index first = 0; first < 8; ++first) {
    for (Eigen::Index size = 0; size < 40; ++size) append(first, size);
  }
  append(0, static_cast<Eigen::Index>(x.size()));
  return results;
}

TEST(Exponential, HasTheTwinsBitsForArraysOnEveryTarget) {
  expect_the_same_bits_on_every_target([] { return bits_of(results_of_arrays()); });
}

TEST(Exponential, RefusesAResultOfAnotherSize) {
  Eigen::ArrayXd x(3), wrong(2);
  EXPECT_THROW(exponential(x, wrong), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
