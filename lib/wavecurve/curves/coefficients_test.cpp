#include "wavecurve/curves/coefficients.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/curves/interpolation.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/dyadic_values.hpp"
#include "wavecurve/transform/plain_transform.hpp"

namespace wavecurve {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
const char* const names[] = {"db2", "db4", "db10", "sym8", "coif2", "bspline4.4", "cdf9.7"};

/// A circle with a wave on it, of size about 1.
Contour flower(Eigen::Index samples) {
  Contour contour(samples, 2);
  for (Eigen::Index i = 0; i < samples; ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(samples);
    const double radius = 1 + 0.2 * std::cos(5 * angle);
    contour.row(i) << radius * std::cos(angle), radius * std::sin(angle);
  }
  return contour;
}

TEST(Coefficients, AreThePlainTransformOfTheSamples) {
  const Contour samples = flower(64);
  for (const char* name : names) {
    const FilterBank<double> bank = find_filter_bank(name);
    const Contour coefficients = to_coefficients(bank, samples, 4);
    for (int column : {0, 1}) {
      const Eigen::VectorXd twin = plain::forward_transform<double>(bank, 4, samples.col(column));
      // Sums of as many products as taps, four levels deep, of values up to 2^{4/2}.
      EXPECT_LE((coefficients.col(column) - twin).cwiseAbs().maxCoeff(), 1000 * epsilon) << name;
    }
  }
}

TEST(Coefficients, GiveTheSamplesAgain) {
  const Contour samples = flower(128);
  for (SampleMode mode : {SampleMode::samples, SampleMode::interpolate}) {
    for (const char* name : names) {
      const FilterBank<double> bank = find_filter_bank(name);
      const Contour back = to_samples(bank, to_coefficients(bank, samples, 5, mode), 5, mode);
      // Rounding is enlarged by the basis' condition and by 1 / symbol, each below 100 here.
      EXPECT_LE((back - samples).cwiseAbs().maxCoeff(), 1e4 * epsilon) << name;
    }
  }
}

/// The curve's points at i / N, summed up from phi at the integers.
TEST(Interpolation, PassesThroughThePoints) {
  const Contour points = flower(32);
  for (const char* name : names) {
    const FilterBank<double> bank = find_filter_bank(name);
    const Contour finest = interpolate(bank, points);
    const DyadicValues phi = scaling_values(bank, 0);
    for (Eigen::Index i = 0; i < 32; ++i) {
      Eigen::RowVector2d point = Eigen::RowVector2d::Zero();
      for (Eigen::Index k = 0; k < phi.values.size(); ++k) {
        const auto n = (i - static_cast<Eigen::Index>(phi.point(k)) + 320) % 32;
        point += phi.values[k] * finest.row(n);
      }
      EXPECT_LE((point - points.row(i)).norm(), 1e4 * epsilon) << name << " " << i;
    }
  }
}

TEST(Interpolation, IsInvertedByTheValuesAtTheIntegers) {
  const Contour finest = flower(64);
  for (const char* name : names) {
    const FilterBank<double> bank = find_filter_bank(name);
    const Contour again = interpolate(bank, values_at_integers(bank, finest));
    EXPECT_LE((again - finest).cwiseAbs().maxCoeff(), 1e4 * epsilon) << name;
  }
}

/// The cubic spline at the integers is 1/6, 4/6, 1/6: the symbol's least modulus is 1/3.
TEST(Interpolation, KnowsTheSplinesSymbol) {
  EXPECT_NEAR(smallest_symbol(find_filter_bank("bspline4.4"), 64), 1.0 / 3, 16 * epsilon);
}

/// The quadratic spline is 1/2, 1/2 at the integers: zero at the highest frequency.
TEST(Interpolation, RefusesAZeroOfTheSymbol) {
  try {
    interpolate(find_filter_bank("bspline3.3"), flower(16));
    ADD_FAILURE();
  } catch (const std::domain_error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("smallest modulus of phi's symbol at 16 points is"), std::string::npos);
    EXPECT_NE(message.find("at least 1e-06"), std::string::npos) << message;
  }
  EXPECT_THROW(interpolate(find_filter_bank("haar"), flower(16)), std::domain_error);
}

/// The trapezoidal rule is exact up to rounding: shifts of phi reproduce x, so that its sum over
/// any grid is the integral.
TEST(Coefficients, KnowTheCentreOfPhi) {
  for (const char* name : names) {
    const FilterBank<double> bank = find_filter_bank(name);
    const DyadicValues phi = scaling_values(bank, 3);
    double sum = 0;
    for (Eigen::Index i = 0; i < phi.values.size(); ++i) sum += phi.point(i) * phi.values[i] / 8;
    EXPECT_NEAR(centre_of_phi(bank), sum, 1e-12) << name;
  }
}

TEST(Approximation, DropsTheDetails) {
  const FilterBank<double> bank = find_filter_bank("db4");
  const Contour coefficients = to_coefficients(bank, flower(64), 3);
  const Contour coarse = approximation(coefficients, 8);
  EXPECT_EQ(coarse.topRows(8), coefficients.topRows(8));
  EXPECT_TRUE(coarse.bottomRows(56).isZero(0));
  EXPECT_EQ(approximation(coefficients, 64), coefficients);
  EXPECT_THROW(approximation(coefficients, 0), std::invalid_argument);
  EXPECT_THROW(approximation(coefficients, 65), std::invalid_argument);
  EXPECT_THROW(to_coefficients(bank, flower(64), 7), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
