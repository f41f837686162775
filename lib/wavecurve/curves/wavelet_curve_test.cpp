#include "wavecurve/curves/wavelet_curve.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/curves/interpolation.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/dyadic_values.hpp"

namespace wavecurve {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Contour random_coefficients(Eigen::Index count) {
  std::mt19937_64 generator;
  Contour result(count, 2);
  for (double& value : result.reshaped()) {
    value = std::ldexp(static_cast<double>(generator() >> 11), -52) - 1;
  }
  return result;
}

struct Case {
  const char* name;
  int largest_order;
};
const Case cases[] = {{"db2", 0},   {"db3", 1},        {"db4", 1},    {"db10", 2}, {"sym8", 2},
                      {"coif2", 1}, {"bspline4.4", 2}, {"cdf9.7", 1}, {"db38", 2}};

/// At i 2^-6 / N the curve is the sum of the table's values. The curve is refined from coefficients
/// up to 1, scaled by (2N)^order; each refinement and each division of the mask sums up products.
TEST(WaveletCurve, HasTheDyadicValues) {
  constexpr Eigen::Index count = 16, unit = 64;
  const Contour c = random_coefficients(count);
  for (const Case& test : cases) {
    const FilterBank<double> bank = find_filter_bank(test.name);
    const WaveletCurve curve(bank, c);
    for (int order = 0; order <= test.largest_order; ++order) {
      const DyadicValues phi = scaling_values(bank, 6, order);
      const double scale = std::pow(static_cast<double>(count), order);
      const double taps = bank.synthesis_low.size();
      const double tolerance = 16 * taps * taps * std::pow(taps / 2, order) * epsilon * scale *
                               phi.values.cwiseAbs().maxCoeff();
      for (Eigen::Index i = 0; i < count * unit; i += 5) {
        Eigen::Vector2d expected = Eigen::Vector2d::Zero();
        const auto first = static_cast<Eigen::Index>(phi.first);
        for (Eigen::Index k = i % unit; k < phi.values.size(); k += unit) {
          const Eigen::Index n = (i - k) / unit - first;
          expected += scale * phi.values[k] * c.row(((n % count) + count) % count);
        }
        const double t = static_cast<double>(i) / static_cast<double>(count * unit);
        EXPECT_LE((curve.derivative(t, order) - expected).norm(), tolerance)
            << test.name << " " << order << " " << t;
      }
    }
  }
}

/// The cubic B-spline on 0 .. 4 and its derivatives by truncated powers.
double spline(double x, int order) {
  const double binomial[] = {1, -4, 6, -4, 1};
  const double factor[] = {1.0 / 6, 1.0 / 2, 1};
  double sum = 0;
  for (int k = 0; k < 5; ++k) {
    if (x > k) sum += binomial[k] * factor[order] * std::pow(x - k, 3 - order);
  }
  return x < 4 ? sum : 0;
}

TEST(WaveletCurve, IsThePiecewisePolynomialOfSplines) {
  constexpr Eigen::Index count = 32;
  const FilterBank<double> bank = find_filter_bank("bspline4.4");
  const Contour c = random_coefficients(count);
  const WaveletCurve curve(bank, c);
  std::mt19937_64 generator;
  for (int i = 0; i < 200; ++i) {
    const double t = std::ldexp(static_cast<double>(generator() >> 11), -53);
    for (int order : {0, 1, 2}) {
      Eigen::Vector2d expected = Eigen::Vector2d::Zero();
      for (Eigen::Index n = -4; n < count + 4; ++n) {
        const double x = t * count - static_cast<double>(n) - bank.synthesis_low.first_index;
        expected += std::pow(count, order) * spline(x, order) * c.row((n + count) % count);
      }
      // Truncated powers of up to 4^3 cancel; four coefficients of size 1 are weighted.
      EXPECT_LE((curve.derivative(t, order) - expected).norm(),
                1000 * epsilon * std::pow(count, order))
          << t << " " << order;
    }
  }
}

/// The derivatives are those of the points: central differences miss h^2 f''' / 6.
TEST(WaveletCurve, HasTheDerivativesOfItsPoints) {
  const WaveletCurve curve(find_filter_bank("db10"), random_coefficients(16));
  const double h = 1e-5;
  for (double t : {0.1, 0.33, 0.707, 0.999999}) {
    const Eigen::Vector2d first = (curve.point(t + h) - curve.point(t - h)) / (2 * h);
    const Eigen::Vector2d second =
        (curve.derivative(t + h, 1) - curve.derivative(t - h, 1)) / (2 * h);
    EXPECT_LE((curve.derivative(t, 1) - first).norm(), 1e-4 * first.norm()) << t;
    EXPECT_LE((curve.derivative(t, 2) - second).norm(), 1e-3 * second.norm()) << t;
  }
}

/// A circle of radius r through 256 points: the spline is of order 4, so that its curvature errs by
/// about the square of the spacing, 6e-4.
TEST(WaveletCurve, HasTheCurvatureOfACircle) {
  constexpr Eigen::Index count = 256;
  constexpr double radius = 5;
  Contour circle(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / count;
    circle.row(i) << radius * std::cos(angle), radius * std::sin(angle);
  }
  const FilterBank<double> bank = find_filter_bank("bspline4.4");
  const WaveletCurve curve(bank, interpolate(bank, circle));
  for (double t : {0.0, 0.1, 0.25, 0.7}) {
    const double angle = 2 * std::numbers::pi * t;
    EXPECT_LE((curve.tangent(t) - Eigen::Vector2d(-std::sin(angle), std::cos(angle))).norm(), 1e-5);
    EXPECT_NEAR(curve.curvature(t), 1 / radius, 6e-4 / radius);
  }
}

TEST(WaveletCurve, HasThePeriodOne) {
  const WaveletCurve curve(find_filter_bank("db4"), random_coefficients(8));
  EXPECT_EQ(curve.point(0.375), curve.point(1.375));
  EXPECT_EQ(curve.point(0.375), curve.point(-0.625));
  // As near as 64 refinements, sums of eight products each, may round.
  EXPECT_LE((curve.point(1e-300) - curve.point(0)).norm(), 64 * 8 * epsilon);
}

template <class Call>
void expect_no_function(Call call, const std::string& exponent) {
  try {
    call();
    ADD_FAILURE() << exponent;
  } catch (const std::domain_error& error) {
    EXPECT_NE(std::string(error.what()).find("the Sobolev exponent is " + exponent),
              std::string::npos)
        << error.what();
  }
}

TEST(WaveletCurve, RefusesDerivativesThatAreNoFunctions) {
  const WaveletCurve d4(find_filter_bank("db2"), random_coefficients(8));
  expect_no_function([&] { d4.tangent(0.5); }, "1,");
  const WaveletCurve d8(find_filter_bank("db4"), random_coefficients(8));
  EXPECT_NO_THROW(d8.tangent(0.5));
  expect_no_function([&] { d8.curvature(0.5); }, "1.776");
  EXPECT_THROW(d8.derivative(0.5, -1), std::invalid_argument);
  EXPECT_THROW(WaveletCurve(find_filter_bank("haar"), random_coefficients(8)), std::domain_error);
}

}  // namespace
}  // namespace wavecurve
