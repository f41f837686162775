// Gaits of real animals, from the folder of shared data beside the project.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"
#include "wavecurve/io/tracks/read_limb_tracks.hpp"
#include "wavecurve/motion/gait/model/fit_gait.hpp"
#include "wavecurve/motion/gait/walk/gait_animation.hpp"
#include "wavecurve/motion/gait/walk/synthesize_gait.hpp"

namespace wavecurve::io {
namespace {

const std::filesystem::path source = WAVECURVE_SOURCE_DIR;
const std::filesystem::path records = source / "../shared/data/gait";

gait::GaitFit fitted(const std::string& record, Eigen::Index scale) {
  gait::GaitFitOptions options{find_filter_bank("bspline4.4"), "bspline4.4"};
  options.scale = scale;
  return gait::fit_gait(read_limb_tracks({records / record}), options);
}

/// The root mean square over limbs and phases of the best of the models.
double chosen_error(const gait::GaitParameters& parameters) {
  double squares = 0;
  int count = 0;
  for (const gait::LimbPath& path : parameters.limbs) {
    for (const gait::PathSpan& span : path.spans) {
      for (const gait::FitQuality& quality : parameters.quality) {
        if (quality.limb != path.limb || quality.phase != span.phase ||
            quality.model != span.motion.model) {
          continue;
        }
        squares += quality.cross_validated * quality.cross_validated;
        ++count;
      }
    }
  }
  return std::sqrt(squares / count);
}

TEST(RecordedGait, FitsATrottingDog) {
  if (!std::filesystem::exists(records)) GTEST_SKIP() << "no " << records;
  const gait::GaitFit fit = fitted("dog_trot_limb_contours.csv.gz", 128);
  // 60 frames a second, half a second a cycle; over ground 1.95 m/s (dog_trot_joints.csv).
  EXPECT_NEAR(fit.cycle.period, 30, 0.3);
  EXPECT_NEAR(fit.cycle.stride, 1.95 / 2, 0.03);
  EXPECT_EQ(fit.cycle.facing, 1);
  // Diagonal limbs in phase.
  EXPECT_NEAR(fit.cycle.limbs[1].touch_down, 0.5, 0.05);
  EXPECT_NEAR(fit.cycle.limbs[2].touch_down, 0.5, 0.15);
  EXPECT_NEAR(fit.cycle.limbs[3].touch_down, 0, 0.15);
  for (const gait::FitQuality& quality : fit.parameters.quality) {
    EXPECT_EQ(quality.cycles, 3);
    if (quality.phase != "swing") continue;
    if (quality.model == gait::GaitModel::quadratic) {
      EXPECT_LE(quality.residual_share_of_stride, 0.067) << quality.limb;
    }
    if (quality.model == gait::GaitModel::cubic) {
      EXPECT_LE(quality.residual_share_of_stride, 0.016) << quality.limb;
      // The foot's alone, in shares of its own way, is the larger figure.
      EXPECT_GT(quality.foot_share_of_excursion, quality.residual_share_of_stride) << quality.limb;
    }
  }
  EXPECT_LE(chosen_error(fit.parameters), 0.01);
}

TEST(RecordedGait, IsOneCycleForAFox) {
  if (!std::filesystem::exists(records)) GTEST_SKIP() << "no " << records;
  const gait::GaitFit fit = fitted("fox_walk_limb_contours.csv.gz", 32);
  EXPECT_TRUE(fit.cycle.is_loop);
  EXPECT_EQ(fit.cycle.period, 48);
  EXPECT_LE(chosen_error(fit.parameters), 0.01);
}

TEST(RecordedGait, LooksLeftForAGallopingDog) {
  if (!std::filesystem::exists(records)) GTEST_SKIP() << "no " << records;
  const gait::GaitFit fit = fitted("dog_gallop_joints.csv", 32);
  EXPECT_EQ(fit.cycle.facing, -1);
  EXPECT_GE(fit.limbs[0].phases[1].runs.size(), 4U);
  // A pair's feet come down a little after each other, hind ones about half a cycle from fore ones.
  const auto& limbs = fit.cycle.limbs;
  EXPECT_LT(limbs[1].touch_down, 0.2);
  EXPECT_NEAR(limbs[2].touch_down, 0.6, 0.15);
  EXPECT_NEAR(limbs[3].touch_down, 0.6, 0.15);
}

// The shipped dog walks with the motion of the recorded one: its feet, in shares of their way, are
// where the recorded ones are, and do not slide.
TEST(RecordedGait, DrivesTheDrawnDog) {
  if (!std::filesystem::exists(records)) GTEST_SKIP() << "no " << records;
  const gait::GaitParameters parameters = fitted("dog_trot_limb_contours.csv.gz", 32).parameters;
  const Drawing dog = read_drawing(source / "docs/examples/dog.svg").drawing;
  gait::GaitAnimationOptions options{find_filter_bank("bspline4.4")};
  const gait::GaitAnimation walk = gait::animate_gait(parameters, dog, options);
  EXPECT_LE(walk.slide, 0.02);
  EXPECT_LE(walk.lift, 0.02);
  // The publication's own cycle, and a coarse drawing, are allowed no more.
  options.subcycles = true;
  EXPECT_LE(gait::animate_gait(parameters, dog, options).slide, 0.02);
  options.scale = 64;
  EXPECT_LE(gait::animate_gait(parameters, dog, options).slide, 0.02);
  const auto paths = gait::gait_paths(parameters);
  for (const motion::AnimatedLayer& layer : walk.animation.layers) {
    const auto path = std::find_if(paths.begin(), paths.end(),
                                   [&](const gait::LimbPath& p) { return p.limb == layer.id; });
    if (path == paths.end()) continue;
    // The lowest point of the drawn limb, and the recorded foot, against the middles of their ways.
    const gait::LimbPath recorded = gait::path_of_point(*path, path->foot);
    const auto frames = static_cast<Eigen::Index>(layer.outline.size() - 1);
    Eigen::VectorXd drawn_x(frames), recorded_x(frames);
    for (Eigen::Index i = 0; i < frames; ++i) {
      const Contour& outline = layer.outline[static_cast<std::size_t>(i)].contours[0];
      Eigen::Index lowest = 0;
      outline.col(1).maxCoeff(&lowest);
      drawn_x[i] = outline(lowest, 0);
      recorded_x[i] =
          gait::pose_at(recorded, static_cast<double>(i) / static_cast<double>(frames))(0, 0);
    }
    drawn_x.array() -= drawn_x.mean();
    recorded_x.array() -= recorded_x.mean();
    EXPECT_GT(drawn_x.dot(recorded_x) / (drawn_x.norm() * recorded_x.norm()), 0.95) << layer.id;
  }
}

}  // namespace
}  // namespace wavecurve::io
