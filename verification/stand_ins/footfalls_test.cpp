#include "verification/stand_ins/footfalls.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "wavecurve/motion/gait/record/canine_joints.hpp"

namespace wavecurve::verification {
namespace {

/// The joints of a walk as tracks, with the toe as the foot.
TEST(Footfalls, AreThoseOfTheWalkButForTheSpeedThatFeetComeAndGoWith) {
  const gait::CanineGait& walk = gait::find_canine_gait("walk");
  const gait::LimbTracks tracks =
      gait::canine_joints(gait::drawn_dog(), walk, Eigen::VectorXd::LinSpaced(301, 0.3, 3.3));
  gait::GaitCycle cycle;
  cycle.period = 1;
  cycle.ground_speed = gait::stride_length(gait::drawn_dog(), walk);
  for (const gait::LimbTrack& track : tracks.limbs) {
    gait::LimbCycle limb;
    limb.limb = track.limb;
    limb.foot = track.outlines[0].rows() - 1;
    cycle.limbs.push_back(limb);
  }
  const Footfalls stances = recorded_footfalls(tracks, cycle);
  // In the swing, of 1 - duty of the cycle, the speed backwards is v (1 - duty - 30 s^2 (1 - s)^2)
  // / (1 - duty) in the ground's v; it is v / 2 where s (1 - s) = sqrt((1 - duty) / 60).
  const double swing = 1 - walk.limbs[0].duty_factor;
  const double s = (1 - std::sqrt(1 - 4 * std::sqrt(swing / 60))) / 2;
  for (std::size_t i = 0; i < 4; ++i) {
    // Within the squares of steps of 0.01.
    EXPECT_NEAR(stances[i].begin, walk.limbs[i].touch_down, 1e-3);
    EXPECT_NEAR(stances[i].length, walk.limbs[i].duty_factor + 2 * s * swing, 1e-3);
  }
}

TEST(Footfalls, NeedFourLimbs) {
  EXPECT_THROW(model_footfalls({}, 1), std::invalid_argument);
  EXPECT_THROW(recorded_footfalls({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::verification
