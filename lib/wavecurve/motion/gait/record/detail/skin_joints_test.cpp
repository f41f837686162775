#include "wavecurve/motion/gait/record/detail/skin_joints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wavecurve/curves/signed_area.hpp"

namespace wavecurve::gait {
namespace {

using Eigen::Index;
using Eigen::RowVector2d;

Contour joints_of(const std::vector<RowVector2d>& points) {
  Contour joints(static_cast<Index>(points.size()), 2);
  for (std::size_t i = 0; i < points.size(); ++i) joints.row(static_cast<Index>(i)) = points[i];
  return joints;
}

double distance_to_bones(const RowVector2d& point, const Contour& joints) {
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i + 1 < joints.rows(); ++i) {
    const RowVector2d bone = joints.row(i + 1) - joints.row(i);
    const double s = (point - joints.row(i)).dot(bone) / bone.squaredNorm();
    const RowVector2d nearest = joints.row(i) + std::clamp(s, 0.0, 1.0) * bone;
    least = std::min(least, (point - nearest).norm());
  }
  return least;
}

/// A chain of four bones that bends by at most 80 degrees at a joint, and by at most 120 in all, so
/// that bones which are no neighbours keep apart; inner corners take less than half of a bone,
/// since tan(40 degrees) < 1.
Contour some_chain() {
  Contour joints(5, 2);
  joints.row(0) << *rc::gen::inRange(-100, 100), *rc::gen::inRange(-100, 100);
  double angle = *rc::gen::inRange(0, 360);
  for (Index i = 1; i < 5; ++i) {
    const double bone = *rc::gen::inRange(20, 50), turn = angle * std::numbers::pi / 180;
    joints.row(i) = joints.row(i - 1) + bone * RowVector2d(std::cos(turn), std::sin(turn));
    angle += (i % 2 == 0 ? 1 : -1) * *rc::gen::inRange(-40, 80);
  }
  return joints;
}

RC_GTEST_PROP(SkinJoints, EveryPointIsAtTheRadiusFromTheNearestBone, ()) {
  const Contour joints = some_chain();
  const double radius = 10;
  const Contour outline = skin_joints({joints}, radius, 128)[0];
  for (const auto& point : outline.rowwise()) {
    // Coordinates up to 300, a few roundings.
    RC_ASSERT(std::abs(distance_to_bones(point, joints) - radius) < 1e-11);
  }
  RC_ASSERT(signed_area(outline) > 0);
}

RC_GTEST_PROP(SkinJoints, PointsBelongToTheLimb, ()) {
  // The outline of a chain that is moved is the outline, moved, point by point.
  const Contour joints = some_chain();
  const double angle = *rc::gen::inRange(0, 360) * std::numbers::pi / 180;
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  Contour moved = joints * turn.transpose();
  moved.col(0).array() += 30;
  const auto outlines = skin_joints({joints, moved}, 10, 128);
  Contour expected = outlines[0] * turn.transpose();
  expected.col(0).array() += 30;
  RC_ASSERT((outlines[1] - expected).cwiseAbs().maxCoeff() < 1e-10);
}

TEST(SkinJoints, OneBoneIsACapsuleFromItsTip) {
  const Contour outline = skin_joints({joints_of({{3, 10}, {3, 50}})}, 5, 1024)[0];
  EXPECT_NEAR((outline.row(0) - RowVector2d(3, 5)).norm(), 0, 1e-12);
  EXPECT_GT(outline(1, 0), 3);  // clockwise as seen
  // Points are uniform, h apart: a circle through them loses (h / r)^2 / 6 of its area.
  const double perimeter = 2 * 40 + 2 * std::numbers::pi * 5, h = perimeter / 1024;
  const double area = 2 * 5 * 40 + std::numbers::pi * 25;
  EXPECT_NEAR(signed_area(outline), area, std::numbers::pi * 25 * h * h / 25 / 6 + 1e-9);
  for (Index k = 1; k < 1024; ++k) {
    EXPECT_NEAR((outline.row(k) - outline.row(k - 1)).norm(), h, 1e-3 * h) << k;
  }
}

TEST(SkinJoints, PointsMoveContinuouslyWhileALimbBendsToAndFro) {
  std::vector<Contour> frames;
  constexpr int steps = 400;
  for (int i = 0; i <= steps; ++i) {
    const double bend = 1.2 * std::sin(2 * std::numbers::pi * i / steps);
    frames.push_back(joints_of({{0, 0}, {0, 30}, {30 * std::sin(bend), 30 + 30 * std::cos(bend)}}));
  }
  const auto outlines = skin_joints(frames, 6, 64);
  for (std::size_t i = 1; i < outlines.size(); ++i) {
    // The angle turns by at most 1.2 * 2 pi / steps a step, about a joint at most 36 away; a point
    // slides along its piece by the change of that one's length, at most twice as much again.
    const double bound = 3 * 36 * 1.2 * 2 * std::numbers::pi / steps;
    EXPECT_LT((outlines[i] - outlines[i - 1]).rowwise().norm().maxCoeff(), bound) << i;
  }
}

TEST(SkinJoints, WhatIsOutsideOfABendKeepsItsPlaceOnTheBone) {
  // The last bone rests while the others bend: so do the sole of the foot and its tip.
  std::vector<Contour> frames;
  for (int i = 0; i <= 20; ++i) frames.push_back(joints_of({{-10.0 + i, 0}, {0, 30}, {20, 30}}));
  const auto outlines = skin_joints(frames, 5, 256);
  int resting = 0;
  for (Index k = 0; k < 256; ++k) {
    const bool sole = outlines[0](k, 1) > 34.999 && outlines[0](k, 0) > 0;
    if (!sole && outlines[0](k, 0) < 20) continue;
    ++resting;
    for (const Contour& outline : outlines) {
      EXPECT_NEAR((outline.row(k) - outlines[0].row(k)).norm(), 0, 1e-12) << k;
    }
  }
  // The sole and the half circle, 20 + 5 pi of about 2 (32 + 20) + 10 pi + 5.
  EXPECT_GT(resting, 256 * 35 / 145);
}

TEST(SkinJoints, JointsThatAlwaysCoincideCountOnce) {
  const RowVector2d a(0, 0), b(4, 30), c(-3, 50);
  const auto plain = skin_joints({joints_of({a, b, c})}, 5, 64);
  EXPECT_EQ(skin_joints({joints_of({a, a, b, b, c, c})}, 5, 64)[0], plain[0]);
}

TEST(SkinJoints, ABoneThatIsAPointAtSomeTimeDoesNoHarm) {
  const auto outlines =
      skin_joints({joints_of({{0, 0}, {0, 0}, {0, 30}}), joints_of({{0, 0}, {5, 20}, {0, 40}}),
                   joints_of({{1, 1}, {1, 1}, {1, 1}})},
                  5, 64);
  for (const Contour& outline : outlines) EXPECT_TRUE(outline.allFinite());
}

TEST(SkinJoints, BadInputIsRefused) {
  const Contour bone = joints_of({{0, 0}, {0, 10}});
  EXPECT_THROW(skin_joints({}, 1, 64), std::invalid_argument);
  EXPECT_THROW(skin_joints({bone}, 1, 63), std::invalid_argument);
  EXPECT_THROW(skin_joints({bone}, 0, 64), std::invalid_argument);
  EXPECT_THROW(skin_joints({bone}, std::nan(""), 64), std::invalid_argument);
  EXPECT_THROW(skin_joints({bone.topRows(1)}, 1, 64), std::invalid_argument);
  EXPECT_THROW(skin_joints({bone, joints_of({{0, 0}, {0, 1}, {0, 2}})}, 1, 64),
               std::invalid_argument);
  EXPECT_THROW(skin_joints({joints_of({{0, 0}, {0, std::nan("")}})}, 1, 64), std::invalid_argument);
  EXPECT_THROW(skin_joints({joints_of({{2, 2}, {2, 2}})}, 1, 64), std::invalid_argument);
}

TEST(ChainLength, IsTheMeanOverTime) {
  EXPECT_DOUBLE_EQ(
      chain_length({joints_of({{0, 0}, {3, 4}, {3, 14}}), joints_of({{0, 0}, {0, 1}, {0, 2}})}),
      8.5);
}

}  // namespace
}  // namespace wavecurve::gait
