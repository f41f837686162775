#include "wavecurve/motion/gait/record/gait_cycle.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "wavecurve/motion/gait/record/planted_gait_test.hpp"

namespace wavecurve::gait {
namespace {

double circular_distance(double a, double b) {
  const double d = std::abs(a - b);
  return std::min(d, 1 - d);
}

void expect_planted(const PlantedGait& plan, const GaitCycle& cycle, double tolerance) {
  EXPECT_NEAR(cycle.period, plan.period, tolerance * plan.period);
  EXPECT_EQ(cycle.facing, plan.facing);
  // 2 reach in the duty factor's share of the period.
  const double speed = 2 * plan.reach / (plan.gait.limbs[0].duty_factor * plan.period);
  EXPECT_NEAR(cycle.ground_speed, speed, tolerance * speed);
  ASSERT_EQ(cycle.limbs.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const LimbCycle& limb = cycle.limbs[i];
    EXPECT_EQ(limb.limb, limb_names[i]);
    EXPECT_NEAR(limb.duty_factor, plan.gait.limbs[i].duty_factor, tolerance);
    EXPECT_LT(circular_distance(limb.touch_down, plan.gait.limbs[i].touch_down), tolerance);
    EXPECT_NEAR(limb.excursion, 2 * plan.reach, 2 * tolerance * plan.reach);
    EXPECT_NEAR(limb.foot, plan.points / 2, 1);  // the lowest point of the ellipse
  }
}

// The foot turns at corners, which the vertex of a parabola rounds off: by up to two of the 40
// frames of a cycle.
TEST(GaitCycle, IsFoundAgain) {
  for (const char* name : {"walk", "trot", "pace"}) {
    for (double facing : {1.0, -1.0}) {
      PlantedGait plan;
      plan.gait = find_canine_gait(name);
      plan.facing = facing;
      plan.period = 0.7;
      expect_planted(plan, analyse_cycle(plan.tracks()), 0.05);
    }
  }
}

TEST(GaitCycle, IsFoundInNoiseAndAtUnevenTimes) {
  PlantedGait plan;
  plan.noise = 0.6;  // 1.5 % of the foot's way
  LimbTracks tracks = plan.tracks();
  expect_planted(plan, analyse_cycle(tracks), 0.08);
  // Every third frame left out.
  LimbTracks sparse{Eigen::VectorXd(0), {}};
  for (const LimbTrack& track : tracks.limbs) sparse.limbs.push_back({track.limb, {}});
  for (Eigen::Index i = 0; i < tracks.times.size(); ++i) {
    if (i % 3 == 1) continue;
    sparse.times.conservativeResize(sparse.times.size() + 1);
    sparse.times[sparse.times.size() - 1] = tracks.times[i];
    for (std::size_t l = 0; l < 4; ++l) {
      sparse.limbs[l].outlines.push_back(tracks.limbs[l].outlines[static_cast<std::size_t>(i)]);
    }
  }
  expect_planted(plan, analyse_cycle(sparse), 0.08);
}

TEST(GaitCycle, IsALoopForARecordThatCloses) {
  PlantedGait plan;
  plan.cycles = 1 - 1.0 / plan.frames_a_cycle;  // the frame after the last is the first
  const GaitCycle cycle = analyse_cycle(plan.tracks());
  EXPECT_TRUE(cycle.is_loop);
  expect_planted(plan, cycle, 0.05);
  plan.cycles = 0.8;
  EXPECT_THROW(analyse_cycle(plan.tracks()), std::invalid_argument);
}

TEST(GaitCycle, OutlineBetweenFramesIsCubic) {
  LimbTracks tracks{Eigen::VectorXd(6), {{"LF", {}}}};
  tracks.times << 0, 1, 1.5, 3, 4, 6;
  const auto cube = [](double t) { return Contour::Constant(4, 2, t * t * t - 2 * t); };
  for (double t : tracks.times) tracks.limbs[0].outlines.push_back(cube(t));
  for (double t : {0.0, 0.4, 2.2, 3.0, 5.9, 6.0}) {
    // Values of 200, weights of a few: some hundred units of rounding.
    EXPECT_NEAR(outline_at(tracks.times, tracks.limbs[0], t)(2, 1), cube(t)(2, 1), 1e-11);
  }
}

std::string refusal(const LimbTracks& tracks) {
  try {
    analyse_cycle(tracks);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(GaitCycle, RefusesWhatIsNoGait) {
  const LimbTracks good = PlantedGait().tracks();
  ASSERT_EQ(refusal(good), "");
  LimbTracks bad = good;
  bad.limbs.erase(bad.limbs.begin(), bad.limbs.begin() + 2);
  EXPECT_EQ(refusal(bad), "there is no track of limb LF or RF, but a gait takes one of them");
  bad = good;
  bad.limbs[1].outlines.pop_back();
  EXPECT_EQ(refusal(bad), "limb 'RF' has 136 outlines, but there are 137 frames");
  bad = good;
  bad.limbs[2].outlines[7] = Contour::Zero(32, 2);
  EXPECT_EQ(refusal(bad), "limb 'LH' has 32 points in frame 7, but must have 64 in all");
  bad = good;
  bad.limbs[3].outlines[9](4, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(bad), "limb 'RH' has a point that is not finite in frame 9");
  bad = good;
  bad.times[5] = bad.times[4];
  EXPECT_EQ(refusal(bad), "the time of frame 5 is 0.1, but times must be finite and increase");
  bad = good;
  bad.limbs[1].limb = "LF";
  EXPECT_EQ(refusal(bad), "limb 'LF' is there twice");
  bad = good;
  for (Contour& outline : bad.limbs[0].outlines) outline = bad.limbs[0].outlines[0];
  EXPECT_EQ(refusal(bad), "the foot of limb 'LF' does not move");
  bad = good;
  bad.times.conservativeResize(3);
  for (LimbTrack& track : bad.limbs) track.outlines.resize(3);
  EXPECT_EQ(refusal(bad), "the number of frames is 3, but must be at least 4");
  bad = good;
  bad.times.conservativeResize(20);
  for (LimbTrack& track : bad.limbs) track.outlines.resize(20);
  EXPECT_NE(refusal(bad).find("a cycle takes 3 reversals"), std::string::npos) << refusal(bad);
}

}  // namespace
}  // namespace wavecurve::gait
