#include "wavecurve/curves/normalized_contour.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "wavecurve/curves/signed_area.hpp"

namespace wavecurve {
namespace {

constexpr Eigen::Index count = 64;

/// A smooth shape without symmetry, from the parameter `start` on: a Fourier series of few terms, so that
/// the one through its points is the curve itself.
Contour shape(double start, double direction = 1) {
  Contour points(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double t = start + direction * 2 * std::numbers::pi * static_cast<double>(i) / count;
    points.row(i) << 5 * std::cos(t) + std::cos(2 * t) + 0.3 * std::sin(3 * t),
        2 * std::sin(t) + 0.5 * std::cos(2 * t) - 0.2 * std::cos(5 * t);
  }
  return points;
}

Contour placed(const Contour& points, double angle, double size, double x, double y) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  return (size * points * turn.transpose()).rowwise() + Eigen::RowVector2d(x, y);
}

TEST(NormalizedContour, StartDirectionRotationSizeAndPlaceDoNotCount) {
  const Contour plain = normalized_contour(shape(0));
  for (const double start : {0.3, 2.0, 3.1, 5.9}) {
    for (const double direction : {1.0, -1.0}) {
      const Contour other =
          normalized_contour(placed(shape(start, direction), 7 * start, 3 + start, 100, -50));
      // A hundred units of a place cost three digits of a double's sixteen.
      EXPECT_LT((other - plain).cwiseAbs().maxCoeff(), 1e-12) << start << " " << direction;
    }
  }
}

TEST(NormalizedContour, HasThePoseThatItPromises) {
  const Contour plain = normalized_contour(placed(shape(1), 1, 4, 3, 2));
  EXPECT_LT(plain.colwise().mean().norm(), 1e-14);
  EXPECT_NEAR(contour_size(plain), 1, 1e-14);
  EXPECT_GT(signed_area(plain), 0);
  EXPECT_GE(plain.col(0).array().cube().sum(), 0);
  EXPECT_GT(plain.col(0).norm(), plain.col(1).norm());
  EXPECT_NEAR(contour_size(placed(shape(1), 1, 4, 3, 2)), 4 * contour_size(shape(0)), 1e-13);
}

TEST(NormalizedContour, AMirroredShapeIsAnother) {
  Contour mirrored = shape(0);
  mirrored.col(1) *= -1;
  EXPECT_GT((normalized_contour(mirrored) - normalized_contour(shape(0))).norm(), 0.1);
}

TEST(NormalizedContour, APointHasNoShape) {
  EXPECT_THROW(normalized_contour(Contour::Constant(8, 2, 0.1)), std::invalid_argument);
  EXPECT_THROW(normalized_contour(shape(0).topRows(3)), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
