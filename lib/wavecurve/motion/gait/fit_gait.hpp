#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/motion/gait/gait_cycle.hpp"
#include "wavecurve/motion/gait/gait_parameters.hpp"
#include "wavecurve/motion/gait/limb_tracks.hpp"

namespace wavecurve {

/// One run of a phase: the frames between two key frames.
struct PhaseRun {
  double begin = 0, end = 0;    ///< times of the key frames
  Contour from, to;             ///< control points at the key frames
  Eigen::VectorXd tau;          ///< of the frames inside, 0 < tau < 1
  std::vector<Contour> points;  ///< control points of these frames
};

struct ModelFit {
  PhaseMotion motion;
  FitQuality quality;
};

struct PhaseFit {
  std::string phase;
  std::vector<PhaseRun> runs;    ///< one a cycle
  std::vector<ModelFit> models;  ///< in the order of gait_models
};

struct LimbFit {
  std::string limb;
  std::vector<PhaseFit> phases;  ///< stance, swing
};

struct GaitFitOptions {
  FilterBank<double> bank;
  std::string filter_name;
  /// Control points at which the fit is made, a power of two from 4 on; none: all points.
  std::optional<Eigen::Index> scale{};
  /// Times of key frames 1 and 2; none: LF's first lift-off, and a quarter of the period later.
  std::optional<std::array<double, 2>> key_frames{};
  /// The model of all phases; none: the one of the least cross-validated error, of each.
  std::optional<GaitModel> model{};
};

struct GaitFit {
  GaitCycle cycle;
  std::vector<LimbFit> limbs;
  GaitParameters parameters;
};

/// Fits all models to all limbs and phases, in the control points of a scale: the K scaling
/// coefficients of the contour at that scale (publication, (2.8), section 4.2), in units of the
/// drawing; at the finest scale, the points themselves.
/// Throws as analyse_cycle does, and std::invalid_argument for outlines whose number of points is
/// no power of two, a scale that is none from 4 to that number, and key frames that are outside the
/// record, equal, or more than half a period apart.
GaitFit fit_gait(const LimbTracks& tracks, const GaitFitOptions& options);

}  // namespace wavecurve
