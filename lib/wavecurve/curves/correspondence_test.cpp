#include "wavecurve/curves/correspondence.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve {
namespace {

using Eigen::Index;

/// A closed curve of a few random Fourier terms: no symmetry, so one shift is best.
Contour random_curve(Index points) {
  const auto number = [] { return *rc::gen::inRange(-1000, 1000) / 1000.0; };
  Contour curve = Contour::Zero(points, 2);
  for (int k = 1; k <= 4; ++k) {
    const double a = number(), b = number(), c = number(), d = number();
    for (Index i = 0; i < points; ++i) {
      const double t =
          2 * std::numbers::pi * k * static_cast<double>(i) / static_cast<double>(points);
      curve.row(i) +=
          Eigen::RowVector2d(a * std::cos(t) + b * std::sin(t), c * std::cos(t) + d * std::sin(t));
    }
  }
  return curve;
}

RC_GTEST_PROP(BestShift, EqualsTheExhaustiveSearch, ()) {
  const Index points = *rc::gen::element<Index>(1, 2, 7, 64, 100, 256);
  const Contour from = random_curve(points), to = random_curve(points);
  for (const Rotation rotation : {Rotation::kept, Rotation::taken_out}) {
    RC_ASSERT(best_shift(from, to, rotation) == plain::best_shift(from, to, rotation));
  }
}

/// The least sum of squared distances for a shift, with place, scale and, if it is to be, rotation
/// taken out by an independent solution: a linear least squares problem in c = (p, q).
double distance(const Contour& from, const Contour& to, Rotation rotation) {
  const Contour z = from.rowwise() - from.colwise().mean();
  const Contour w = to.rowwise() - to.colwise().mean();
  Eigen::MatrixXd basis(2 * w.rows(), 2);
  basis << w.col(0), -w.col(1), w.col(1), w.col(0);
  const Eigen::VectorXd target = z.reshaped();
  if (rotation == Rotation::taken_out) {
    const Eigen::VectorXd c = basis.householderQr().solve(target);
    return (target - basis * c).squaredNorm();
  }
  const double scale = std::max(0.0, basis.col(0).dot(target) / basis.col(0).squaredNorm());
  return (target - scale * basis.col(0)).squaredNorm();
}

RC_GTEST_PROP(BestShift, LeavesTheLeastDistance, ()) {
  const Contour from = random_curve(64), to = random_curve(64);
  RC_PRE(from.norm() > 0.1 && to.norm() > 0.1);
  for (const Rotation rotation : {Rotation::kept, Rotation::taken_out}) {
    const double least = distance(from, started_at(to, best_shift(from, to, rotation)), rotation);
    for (Index s = 0; s < 64; ++s) {
      // The tie rule may lose 64 units of rounding of the squared norms; the solver as much again.
      RC_ASSERT(least <= distance(from, started_at(to, s), rotation) + 1e-12 * from.squaredNorm());
    }
  }
}

RC_GTEST_PROP(BestShift, FindsTheStartOfAMovedScaledAndTurnedCurve, ()) {
  const Contour from = random_curve(128);
  RC_PRE(plain::best_shift(from, from) == 0 && from.norm() > 0.1);
  const Index shift = *rc::gen::inRange(0, 128);
  const Contour started = started_at(from, shift);
  const Contour moved = (2.5 * started).rowwise() + Eigen::RowVector2d(10, -3);
  RC_ASSERT(best_shift(from, moved) == (128 - shift) % 128);
  const Contour turned = moved * Eigen::Rotation2Dd(2).toRotationMatrix();
  const Contour again = started_at(turned, best_shift(from, turned, Rotation::taken_out));
  RC_ASSERT(distance(from, again, Rotation::taken_out) <= 1e-12 * from.squaredNorm());
}

TEST(BestShift, TakesTheFirstOfEqualShifts) {
  Contour square(4, 2);
  square << 0, 0, 1, 0, 1, 1, 0, 1;
  EXPECT_EQ(best_shift(square, square, Rotation::taken_out), 0);
  EXPECT_EQ(best_shift(Contour::Zero(8, 2), Contour::Zero(8, 2)), 0);
}

TEST(BestShift, RefusesDifferentSizes) {
  EXPECT_THROW(best_shift(Contour::Zero(4, 2), Contour::Zero(8, 2)), std::invalid_argument);
  EXPECT_THROW(best_shift(Contour(0, 2), Contour(0, 2)), std::invalid_argument);
  // Their mean overflows, and no shift would be the best one.
  const Contour huge = Contour::Constant(4, 2, 1.5e308);
  EXPECT_THROW(best_shift(huge, huge), std::domain_error);
  EXPECT_THROW(started_at(Contour::Zero(4, 2), 4), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
