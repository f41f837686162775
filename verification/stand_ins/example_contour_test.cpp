#include "verification/stand_ins/example_contour.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "wavecurve/curves/signed_area.hpp"

#include "verification/stand_ins/fourier_descriptor.hpp"

namespace wavecurve::verification {
namespace {

TEST(ExampleContour, IsTheDigit) {
  const Contour digit = example_contour("three.svg", 256);
  EXPECT_EQ(digit.rows(), 256);
  EXPECT_GT(signed_area(digit), 0);
  // It nearly fills its view box of 160 x 220.
  EXPECT_GT(diagonal(digit), 200);
  EXPECT_LT(diagonal(digit), 272);
}

TEST(Distances, AreThoseOfTheirDefinitions) {
  Contour a(2, 2), b(2, 2);
  a << 0, 0, 3, 4;
  b << 1, 0, 3, 7;
  EXPECT_EQ(diagonal(a), 5);
  EXPECT_EQ(rms_distance(a, b), std::sqrt(5.0));
}

/// An ellipse has the frequencies 1 and -1 only; a ripple of frequency 9 is left out.
TEST(FourierDescriptor, KeepsTheLowestFrequencies) {
  constexpr Eigen::Index count = 64;
  Contour ellipse(count, 2), rippled(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / count;
    ellipse.row(i) << 3 * std::cos(angle), std::sin(angle);
    rippled.row(i) = ellipse.row(i) + 0.1 * Eigen::RowVector2d(std::cos(9 * angle), 0);
  }
  EXPECT_LE(rms_distance(fourier_approximation(rippled, 16), ellipse), 1e-14);
  EXPECT_LE(rms_distance(fourier_approximation(rippled, 64), rippled), 1e-14);
  EXPECT_GT(rms_distance(fourier_approximation(rippled, 20), ellipse), 0.05);
}

}  // namespace
}  // namespace wavecurve::verification
