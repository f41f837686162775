#include "wavecurve/motion/gait/record/detail/body_frame.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "wavecurve/motion/gait/record/canine_joints.hpp"

namespace wavecurve::gait {
namespace {

using Eigen::Index;

LimbTracks trot() {
  return canine_joints(drawn_dog(), find_canine_gait("trot"),
                       Eigen::VectorXd::LinSpaced(40, 0, 1.95));
}

TEST(BodyFrame, FeetTellWhichWayIsUp) {
  LimbTracks tracks = trot();
  EXPECT_FALSE(y_points_up(tracks));
  for (LimbTrack& limb : tracks.limbs) {
    for (Contour& joints : limb.outlines) joints.col(1) *= -1;
  }
  EXPECT_TRUE(y_points_up(tracks));
}

TEST(BodyFrame, ATailThatWagsDoesNotCountAsALimb) {
  LimbTracks tracks = trot();
  LimbTrack tail{"TAIL", {}};
  for (Index i = 0; i < tracks.times.size(); ++i) {
    Contour joints(2, 2);
    joints << 80, 100, 40 + 1000 * std::sin(static_cast<double>(i)), 50;
    tail.outlines.push_back(joints);
  }
  tracks.limbs.push_back(tail);
  EXPECT_FALSE(y_points_up(tracks));
}

TEST(BodyFrame, TravelIsTakenOut) {
  LimbTracks moving = trot();
  const LimbTracks still = moving;
  take_out_travel(moving);
  EXPECT_EQ(moving.limbs[0].outlines[3], still.limbs[0].outlines[3]);
  for (Index i = 0; i < moving.times.size(); ++i) {
    for (LimbTrack& limb : moving.limbs) {
      limb.outlines[static_cast<std::size_t>(i)].col(0).array() += 20 * static_cast<double>(i);
    }
  }
  take_out_travel(moving);
  // Pivots of the drawn dog are at 112 and 228.
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < moving.limbs[k].outlines.size(); ++i) {
      Contour expected = still.limbs[k].outlines[i];
      expected.col(0).array() -= 170;
      EXPECT_LT((moving.limbs[k].outlines[i] - expected).cwiseAbs().maxCoeff(), 1e-10);
    }
  }
}

}  // namespace
}  // namespace wavecurve::gait
