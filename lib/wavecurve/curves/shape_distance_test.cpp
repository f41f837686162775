#include "wavecurve/curves/shape_distance.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/normalized_contour.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/bands.hpp"

namespace wavecurve {
namespace {

constexpr Eigen::Index count = 64;
constexpr int levels = 4;

FilterBank<double> bank() { return find_filter_bank("coif2"); }

/// A smooth shape, from the parameter `start` on, with a ripple of a high frequency.
Contour shape(double start, double ripple = 0, double direction = 1) {
  Contour points(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double t = start + direction * 2 * std::numbers::pi * static_cast<double>(i) / count;
    const double radius =
        1 + 0.3 * std::cos(2 * t) + 0.2 * std::sin(3 * t) + ripple * std::cos(20 * t);
    points.row(i) << radius * std::cos(t), radius * std::sin(t);
  }
  return points;
}

Contour placed(const Contour& points, double angle, double size) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  return (size * points * turn.transpose()).rowwise() + Eigen::RowVector2d(7, -3);
}

TEST(ShapeDistance, StartDirectionRotationSizeAndPlaceDoNotCount) {
  for (const double start : {0.0, 0.7, 3.14, 5.0}) {
    for (const double direction : {1.0, -1.0}) {
      const Contour other = placed(shape(start, 0, direction), 2 + start, 0.1 + start);
      // The shift is found to 4e-9 of a step or so, by values that are exact to 1e-16 and fall like its square:
      // to 1e-8 of the size.
      EXPECT_LT(shape_distance(shape(0), other, bank(), levels).total, 1e-6);
      EXPECT_LT(elliptic_fourier_distance(shape(0), other), 1e-12);
    }
  }
}

TEST(ShapeDistance, IsTheSameInBothDirections) {
  const Contour one = shape(0.4), other = placed(shape(2, 0.05), 1, 3);
  const ShapeDistance there = shape_distance(one, other, bank(), levels);
  const ShapeDistance back = shape_distance(other, one, bank(), levels);
  EXPECT_GT(there.total, 0.01);
  EXPECT_NEAR(there.total, back.total, 1e-7);
  EXPECT_LT((there.by_scale - back.by_scale).norm(), 1e-6);
  EXPECT_NEAR(elliptic_fourier_distance(one, other), elliptic_fourier_distance(other, one), 1e-12);
}

TEST(ShapeDistance, SquaresOfTheScalesAddUp) {
  const ShapeDistance distance = shape_distance(shape(0), shape(1, 0.1), bank(), levels);
  EXPECT_EQ(distance.by_scale.size(), levels + 1);
  EXPECT_NEAR(distance.by_scale.norm(), distance.total, 1e-12);
}

TEST(ShapeDistance, ARippleIsADifferenceOfFineScales) {
  const ShapeDistance ripple = shape_distance(shape(0), shape(0, 0.05), bank(), levels);
  EXPECT_GT(ripple.by_scale.tail(2).norm(), 0.9 * ripple.total);
  Contour stretched = shape(0);
  stretched.col(0) *= 1.3;
  const ShapeDistance coarse = shape_distance(shape(0), stretched, bank(), levels);
  EXPECT_LT(coarse.by_scale.tail(2).norm(), 0.1 * coarse.total);
}

/// The scales' shares, by their definition: band energies of the difference, from every start in turn.
TEST(ShapeDistance, TheScalesAreThoseOfTheTransformFromEveryStart) {
  const Contour one = shape(0), other = shape(0, 0.1);
  const ShapeDistance distance = shape_distance(one, other, bank(), levels);
  const auto standard = [](const Contour& points) {
    const Contour about_mean = points.rowwise() - points.colwise().mean();
    return Contour(about_mean / contour_size(points));
  };
  // The shapes lie alike already, as the search finds.
  ASSERT_NEAR(std::sin(distance.shift), 0, 1e-3);
  ASSERT_NEAR(std::sin(distance.angle), 0, 1e-3);
  const Contour difference = standard(one) - standard(other);
  Eigen::VectorXd energies = Eigen::VectorXd::Zero(levels + 1);
  const auto bands = multiscale_bands(count, levels);
  for (Eigen::Index start = 0; start < count; ++start) {
    const Contour coefficients = to_coefficients(bank(), started_at(difference, start), levels);
    for (Eigen::Index i = 0; i <= levels; ++i) {
      const Band& band = bands[static_cast<std::size_t>(i)];
      energies[i] += coefficients.middleRows(band.offset, band.size).squaredNorm() / count / count;
    }
  }
  // The little that the search turns and shifts makes the whole less, by a second order of 1e-3.
  EXPECT_LT((energies.cwiseSqrt() - distance.by_scale).norm(), 1e-3 * distance.total);
}

TEST(ShapeDistance, OpenCurvesStartAtEitherEnd) {
  Contour there_and_back(count, 2), other(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double t = static_cast<double>(i <= count / 2 ? i : count - i) / (count / 2.0);
    there_and_back.row(i) << t, t * t * t;
    other.row(i) << 1 - t, (1 - t) * (1 - t) * (1 - t);
  }
  EXPECT_LT(shape_distance(there_and_back, placed(other, 1, 2), bank(), levels, false).total,
            1e-12);
}

TEST(ShapeDistance, WhatCannotBeComparedIsRefused) {
  EXPECT_THROW(shape_distance(shape(0), shape(0).topRows(32), bank(), levels),
               std::invalid_argument);
  EXPECT_THROW(shape_distance(shape(0), shape(0), find_filter_bank("bspline4.4"), levels),
               std::invalid_argument);
  EXPECT_THROW(shape_distance(shape(0), Contour::Ones(count, 2), bank(), levels),
               std::invalid_argument);
  EXPECT_THROW(shape_distance(shape(0), shape(0), bank(), 9), std::invalid_argument);
  EXPECT_THROW(elliptic_fourier_distance(shape(0), shape(0), 32), std::invalid_argument);
  EXPECT_THROW(elliptic_fourier_distance(shape(0), shape(0), 0), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
