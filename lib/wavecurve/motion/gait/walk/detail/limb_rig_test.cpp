#include "wavecurve/motion/gait/walk/detail/limb_rig.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/sample_contour.hpp"

namespace wavecurve::gait {
namespace {

/// A limb with a knee in the middle, bent by an angle there and turned by another at the hinge: a
/// strip of constant width along the two lines.
Contour bent_limb(double at_hinge, double at_knee, double size, double width) {
  constexpr int half = 64;
  Contour outline(2 * half, 2);
  for (int i = 0; i < 2 * half; ++i) {
    const int step = i < half ? i : 2 * half - 1 - i;
    const double s = (step + 0.5) / half;
    const double upper = std::min(s, 0.5), lower = std::max(s - 0.5, 0.0);
    const Eigen::RowVector2d a(std::sin(at_hinge), std::cos(at_hinge));
    const Eigen::RowVector2d b(std::sin(at_hinge + at_knee), std::cos(at_hinge + at_knee));
    const Eigen::RowVector2d along = s < 0.5 ? a : b;
    // The right side downwards, then the left one upwards: clockwise as seen.
    const Eigen::RowVector2d side(along.y(), -along.x());
    outline.row(i) = size * (upper * a + lower * b + (i < half ? 1 : -1) * width * side);
  }
  return outline;
}

Contour uniform(const Contour& outline) { return sample_contour(outline, outline.rows()); }

TEST(Midline, RunsInTheMiddle) {
  const Contour outline = bent_limb(0.2, 0, 10, 0.1);
  const Midline midline(outline, 64);
  const Contour nodes = midline.nodes(outline);
  EXPECT_EQ(midline.shares()[64], 1);
  EXPECT_EQ(midline.shares()[midline.hinge()], 0);
  // On the axis, but near the ends, which are corners here, not caps; between points that are a
  // 64th of the length apart.
  for (Eigen::Index i = 6; i + 6 < nodes.rows(); ++i) {
    EXPECT_NEAR(nodes(i, 0) * std::cos(0.2) - nodes(i, 1) * std::sin(0.2), 0, 10.0 / 64) << i;
  }
  EXPECT_THROW(Midline(outline, 128), std::invalid_argument);
  EXPECT_THROW(Midline(Contour::Zero(8, 2), 3), std::invalid_argument);
}

TEST(LimbRig, InTheReferencePoseIsTheDrawing) {
  const Contour reference = bent_limb(0.3, -0.5, 10, 0.1);
  const Contour drawn = started_at(uniform(bent_limb(0.2, -0.3, 40, 0.15)), 17);
  const LimbRig rig(reference, 64, drawn);
  // Turned by nothing: rounding of values of 40.
  EXPECT_LT((rig.pose(reference) - drawn).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(rig.hinge_shift(reference).norm(), 0);
  // The shapes differ a little: by a few of 128 points.
  EXPECT_NEAR(rig.foot(), 64 - 17, 5);
}

// A recorded limb that turns as a whole turns the drawn one about its hinge, by the same angle.
TEST(LimbRig, TurnsAsTheRecordedLimbDoes) {
  const Contour reference = bent_limb(0, -0.4, 10, 0.1),
                drawn = uniform(bent_limb(0.1, -0.2, 40, 0.15));
  const LimbRig rig(reference, 64, drawn);
  const Contour pose = rig.pose(bent_limb(0.5, -0.4, 10, 0.1));
  const Contour nodes = Midline(drawn, rig.foot()).nodes(drawn);
  const Eigen::RowVector2d hinge = nodes.row(0);
  // y points down: an angle from the downward direction towards x turns against the clock as seen.
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-0.5).toRotationMatrix();
  const Contour expected = ((drawn.rowwise() - hinge) * turn.transpose()).rowwise() + hinge;
  EXPECT_LT((pose - expected).cwiseAbs().maxCoeff(), 1e-9);
}

// Whatever the pose, the drawn limb keeps its length and width.
TEST(LimbRig, KeepsLengthAndWidth) {
  const Contour reference = bent_limb(0, 0, 10, 0.08), drawn = uniform(bent_limb(0, 0, 40, 0.08));
  const LimbRig rig(reference, 64, drawn);
  const Contour pose = rig.pose(bent_limb(-0.4, 0.9, 10, 0.08));
  const Contour before = Midline(drawn, rig.foot()).nodes(drawn);
  const Contour after = Midline(drawn, rig.foot()).nodes(pose);
  const auto length = [](const Contour& nodes) {
    return (nodes.bottomRows(31) - nodes.topRows(31)).rowwise().norm().sum();
  };
  // The middle of the two sides of a bend is not quite the axis.
  EXPECT_NEAR(length(after), length(before), 0.02 * 40);
  // The distance of points on both sides of a straight part, that turn by nearly the same.
  for (Eigen::Index i : {10, 50}) {
    const double width = (drawn.row(i) - drawn.row(127 - i)).norm();
    EXPECT_NEAR((pose.row(i) - pose.row(127 - i)).norm(), width, 0.1 * width);
  }
}

TEST(LimbRig, HingesDoNotMoveFar) {
  const Contour reference = bent_limb(0, 0, 10, 0.08), drawn = uniform(bent_limb(0, 0, 40, 0.08));
  const LimbRig rig(reference, 64, drawn);
  const Contour little = reference.rowwise() + Eigen::RowVector2d(0.1, -0.05);
  // Four times as large, and tanh x = x to x^3 / 3.
  EXPECT_NEAR(rig.hinge_shift(little).x(), 0.4, 0.01);
  EXPECT_NEAR(rig.hinge_shift(little).y(), -0.2, 0.01);
  const Contour far = reference.rowwise() + Eigen::RowVector2d(9, 0);
  EXPECT_LT(rig.hinge_shift(far).x(), 0.08 * 40 * 1.08);  // the midline begins and ends in corners
}

}  // namespace
}  // namespace wavecurve::gait
