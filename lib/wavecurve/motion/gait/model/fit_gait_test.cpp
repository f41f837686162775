#include "wavecurve/motion/gait/model/fit_gait.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/motion/gait/model/detail/control_points.hpp"
#include "wavecurve/motion/gait/record/planted_gait_test.hpp"
#include "wavecurve/motion/gait/walk/ground_contact.hpp"
#include "wavecurve/motion/gait/walk/synthesize_gait.hpp"

namespace wavecurve::gait {
namespace {

/// The fitted animal's own outlines, `frames` equidistant ones of one cycle (the one after the last
/// is the first), from `scale` control points, at most the fitted number.
LimbTracks synthesize_limbs(const GaitParameters& parameters, const FilterBank<double>& bank,
                            const std::vector<LimbPath>& paths, int frames, Eigen::Index scale) {
  const ControlPoints fine(bank, parameters.samples, parameters.scale);
  const ControlPoints coarse(bank, parameters.samples, scale);
  const bool is_coarser = scale < parameters.scale;
  LimbTracks tracks{Eigen::VectorXd(frames), {}};
  for (int i = 0; i < frames; ++i) tracks.times[i] = parameters.period * i / frames;
  for (const LimbPath& path : paths) {
    LimbTrack track{path.limb, {}};
    for (int i = 0; i < frames; ++i) {
      Contour outline = fine.draw(pose_at(path, static_cast<double>(i) / frames));
      if (is_coarser) outline = coarse.draw(coarse.analyse(outline));
      track.outlines.push_back(std::move(outline));
    }
    tracks.limbs.push_back(std::move(track));
  }
  return tracks;
}

using Eigen::Index;

GaitFitOptions options_at(std::optional<Index> scale = std::nullopt) {
  GaitFitOptions options{find_filter_bank("bspline4.4"), "bspline4.4"};
  options.scale = scale;
  return options;
}

std::map<GaitModel, FitQuality> quality_of(const GaitParameters& parameters, const char* limb,
                                           const char* phase) {
  std::map<GaitModel, FitQuality> result;
  for (const FitQuality& quality : parameters.quality) {
    if (quality.limb == limb && quality.phase == phase) result[quality.model] = quality;
  }
  return result;
}

// Reversals are corners here, found to a part of a frame; then the key frames are not quite the
// ends of the planted swing, and gamma differs by some hundredths.
TEST(FitGait, FindsAPlantedGaitAgain) {
  PlantedGait plan;
  plan.frames_a_cycle = 200;
  plan.points = 16;
  const GaitFit fit = fit_gait(plan.tracks(), options_at());
  ASSERT_EQ(fit.parameters.limbs.size(), 4U);
  EXPECT_NEAR(fit.parameters.stride, 2 * plan.reach / 0.62, 0.02 * plan.reach);
  for (const PhaseGammas& gammas : fit.parameters.gammas) {
    if (gammas.phase != "swing") continue;
    // The foot's x; y has no gamma, since it is back where it was.
    EXPECT_NEAR(gammas.gamma[plan.points / 2], plan.gamma, 0.1) << gammas.limb;
  }
  for (const LimbPath& path : fit.parameters.limbs) {
    ASSERT_EQ(path.spans.size(), 2U);
    for (double u = 0; u < 1; u += 0.05) {
      const auto limb = static_cast<std::size_t>(
          std::find(limb_names.begin(), limb_names.end(), path.limb) - limb_names.begin());
      // The foot moves by 2 reach / 0.38 a cycle in the swing, and reversals err by a frame.
      EXPECT_LT((pose_at(path, u) - plan.pose(limb, u)).cwiseAbs().maxCoeff(),
                2 * plan.reach / 0.38 / plan.frames_a_cycle * 4)
          << path.limb << " at " << u;
    }
  }
}

// There, control points are the points, and each gamma is that of its point.
TEST(FitGait, AtTheFinestScaleIsTheFitOnPoints) {
  PlantedGait plan;
  plan.points = 32;
  plan.noise = 0.3;
  const LimbTracks tracks = plan.tracks();
  const GaitFit all = fit_gait(tracks, options_at());
  const GaitFit finest = fit_gait(tracks, options_at(plan.points));
  for (std::size_t l = 0; l < 4; ++l) {
    for (std::size_t phase : {0U, 1U}) {
      const auto& points = all.limbs[l].phases[phase].runs.front();
      const LimbCycle& limb = all.cycle.limbs[l];
      // The data are the points, and each gamma that of its point alone.
      const PhaseRun direct = phase_run(tracks.times, tracks.limbs[l], points.begin, points.end);
      EXPECT_EQ(points.points, direct.points) << limb.limb;
      const auto& a = all.parameters.gammas[2 * l + phase].gamma;
      const auto& b = finest.parameters.gammas[2 * l + phase].gamma;
      EXPECT_TRUE(((a.array() == b.array()) || (a.array().isNaN() && b.array().isNaN())).all());
    }
  }
}

// Coarser: control points are a linear map of the points, so that a polynomial fitted to points and
// then mapped is the one fitted to control points, to rounding.
TEST(FitGait, CommutesWithTheTransform) {
  PlantedGait plan;
  plan.points = 32;
  plan.noise = 0.3;
  const LimbTracks tracks = plan.tracks();
  const GaitFit fine = fit_gait(tracks, options_at());
  const GaitFit coarse = fit_gait(tracks, options_at(16));
  const ControlPoints map(find_filter_bank("bspline4.4"), plan.points, 16);
  for (std::size_t l = 0; l < 4; ++l) {
    for (GaitModel model : {GaitModel::cubic, GaitModel::sextic, GaitModel::fourier}) {
      const auto m = static_cast<std::size_t>(model);
      const Eigen::MatrixXd& of_points = fine.limbs[l].models[1][m].motion.parameters;
      const Eigen::MatrixXd& of_control_points = coarse.limbs[l].models[1][m].motion.parameters;
      for (Index row = 0; row < of_points.rows(); ++row) {
        const Contour mapped = map.analyse(of_points.row(row).reshaped(plan.points, 2));
        const Contour fitted = of_control_points.row(row).reshaped(16, 2);
        EXPECT_LT((mapped - fitted).cwiseAbs().maxCoeff(), 1e-10) << model_name(model);
      }
    }
  }
}

TEST(FitGait, ChoosesByCyclesThatAreLeftOut) {
  PlantedGait plan;
  plan.noise = 0.2;
  const GaitFit fit = fit_gait(plan.tracks(), options_at(16));
  for (const LimbPath& path : fit.parameters.limbs) {
    for (const PathSpan& span : path.spans) {
      const auto all = quality_of(fit.parameters, path.limb.c_str(), span.phase.c_str());
      ASSERT_EQ(all.size(), gait_models.size());
      for (const auto& [model, quality] : all) {
        EXPECT_GE(quality.cross_validated, all.at(span.motion.model).cross_validated);
        EXPECT_GE(quality.cycles, 2);
      }
    }
  }
  GaitFitOptions options = options_at(16);
  options.models = {GaitModel::oscillator};
  for (const LimbPath& path : fit_gait(plan.tracks(), options).parameters.limbs) {
    EXPECT_EQ(path.spans[1].motion.model, GaitModel::oscillator);
  }
}

TEST(FitGait, NeedsOneSideOnly) {
  PlantedGait plan;
  plan.frames_a_cycle = 200;
  LimbTracks left = plan.tracks();
  std::erase_if(left.limbs, [](const LimbTrack& track) { return track.limb[0] == 'R'; });
  const GaitFit fit = fit_gait(left, options_at(16));
  EXPECT_EQ(fit.parameters.limbs.size(), 2U);
  EXPECT_EQ(fit.parameters.subcycles.size(), 2U);
  EXPECT_EQ(gait_paths(fit.parameters).size(), 4U);
}

std::string refusal(const LimbTracks& tracks, const GaitFitOptions& options) {
  try {
    fit_gait(tracks, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(FitGait, RefusesBadScalesAndKeyFrames) {
  PlantedGait plan;
  const LimbTracks tracks = plan.tracks();
  EXPECT_EQ(refusal(tracks, options_at(3)),
            "limb 'LF': scale is 3, but must be a power of two from 4 to 64");
  EXPECT_EQ(refusal(tracks, options_at(128)),
            "limb 'LF': scale is 128, but must be a power of two from 4 to 64");
  GaitFitOptions options = options_at(16);
  options.key_frames = {1, 9};
  EXPECT_EQ(refusal(tracks, options), "key frame 2 is at 9, but the record is from 0 to 3.4");
  options.key_frames = {1, 1};
  EXPECT_NE(refusal(tracks, options).find("key frame 2 is 0 after key frame 1"), std::string::npos);
  plan.points = 60;
  EXPECT_EQ(
      refusal(plan.tracks(), options_at()),
      "limb 'LF': the number of points of an outline is 60, but must be a power of two, at least 4");
}

// The publication's cycle: the four key poses are those of the record, and left and right change
// places half a cycle later.
TEST(Subcycles, PassThroughTheirKeyFrames) {
  PlantedGait plan;
  plan.frames_a_cycle = 100;
  const LimbTracks tracks = plan.tracks();
  GaitFitOptions options = options_at(16);
  options.key_frames = {1.2, 1.45};
  const GaitFit fit = fit_gait(tracks, options);
  const ControlPoints points(options.bank, plan.points, 16);
  const auto paths = subcycle_paths(fit.parameters);
  ASSERT_EQ(paths.size(), 4U);
  for (std::size_t limb = 0; limb < 4; ++limb) {
    for (double key : *options.key_frames) {
      const double u = paths[0].offset + key - 1.2;
      const Contour now = pose_at(paths[limb], u), later = pose_at(paths[limb ^ 1], u + 0.5);
      // Left and right outlines of a pair are the same here, and key frames are frames.
      const Contour recorded = points.analyse(plan.pose(limb, key));
      EXPECT_LT((now - recorded).cwiseAbs().maxCoeff(), 1e-9) << limb_names[limb];
      EXPECT_LT((now - later).cwiseAbs().maxCoeff(), 1e-9) << limb_names[limb];
    }
    double sum = 0;
    for (const PathSpan& span : paths[limb].spans) sum += span.share;
    EXPECT_NEAR(sum, 1, 1e-14);
  }
}

TEST(GaitPaths, RightLimbsAreTheLeftOnesHalfACycleOn) {
  PlantedGait plan;
  LimbTracks left = plan.tracks();
  std::erase_if(left.limbs, [](const LimbTrack& track) { return track.limb[0] == 'R'; });
  const GaitParameters parameters = fit_gait(left, options_at(16)).parameters;
  for (const auto& paths : {gait_paths(parameters), subcycle_paths(parameters),
                            gait_paths(parameters, find_canine_gait("pace"))}) {
    for (double u : {0.0, 0.2, 0.7}) {
      // Shares of the cycle are rounded, and a foot moves by 100 a cycle.
      EXPECT_LT((pose_at(paths[0], u) - pose_at(paths[1], u + 0.5)).cwiseAbs().maxCoeff(), 1e-12);
      EXPECT_LT((pose_at(paths[2], u) - pose_at(paths[3], u + 0.5)).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

TEST(GaitPaths, StandWhenTheGaitHasIt) {
  const GaitParameters parameters = fit_gait(PlantedGait().tracks(), options_at(16)).parameters;
  for (const CanineGait& gait : canine_gaits()) {
    const auto paths = gait_paths(parameters, gait);
    for (std::size_t i = 0; i < 4; ++i) {
      const CyclePart contact = ground_contact(paths[i], parameters.facing);
      // Found on a grid of 1/256, from speeds over 1/16 of the cycle.
      EXPECT_NEAR(contact.length, gait.limbs[i].duty_factor, 0.05) << gait.name;
      const double lag = contact.begin - gait.limbs[i].touch_down;
      EXPECT_NEAR(lag - std::round(lag), 0, 0.05) << gait.name;
    }
  }
}

TEST(SynthesizeLimbs, DrawsTheRecordAgain) {
  PlantedGait plan;
  plan.frames_a_cycle = 200;
  const GaitParameters parameters = fit_gait(plan.tracks(), options_at(32)).parameters;
  const auto bank = find_filter_bank("bspline4.4");
  const LimbTracks cycle = synthesize_limbs(parameters, bank, gait_paths(parameters), 40, 64);
  ASSERT_EQ(cycle.limbs.size(), 4U);
  ASSERT_EQ(cycle.limbs[0].outlines.size(), 40U);
  EXPECT_LT((cycle.limbs[2].outlines[10] - plan.pose(2, 0.25)).cwiseAbs().maxCoeff(), 1);
  // Fewer control points, smoother outlines, the same place: the mean is kept by the transform.
  const LimbTracks coarse = synthesize_limbs(parameters, bank, gait_paths(parameters), 40, 4);
  const Contour &a = cycle.limbs[0].outlines[5], &b = coarse.limbs[0].outlines[5];
  EXPECT_LT((a.colwise().mean() - b.colwise().mean()).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_GT((a - b).cwiseAbs().maxCoeff(), 0.1);
}

}  // namespace
}  // namespace wavecurve::gait
