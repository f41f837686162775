#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/motion/gait/model/fit_models.hpp"
#include "wavecurve/motion/gait/model/gait_parameters.hpp"
#include "wavecurve/motion/gait/model/phase_data.hpp"
#include "wavecurve/motion/gait/record/gait_cycle.hpp"
#include "wavecurve/motion/gait/record/limb_tracks.hpp"

namespace wavecurve::gait {

struct LimbFit {
  std::string limb;
  std::vector<PhaseData> phases;              ///< stance, swing
  std::vector<std::vector<ModelFit>> models;  ///< of each phase, in the order of the options'
};

struct GaitFitOptions {
  FilterBank<double> bank;
  std::string filter;  ///< the name of the bank
  /// Control points at which the fit is made, a power of two from 4 on; none: all points.
  std::optional<Eigen::Index> scale{};
  /// Times of key frames 1 and 2; none: LF's first lift-off, and a quarter of the period later.
  std::optional<std::array<double, 2>> key_frames{};
  /// Those that are fitted; each phase takes the one of the least cross-validated error, of equal
  /// ones the first.
  std::vector<GaitModel> models{gait_models.begin(), gait_models.end()};
};

struct GaitFit {
  GaitCycle cycle;
  std::vector<LimbFit> limbs;        ///< as in the cycle
  std::vector<PhaseData> subcycles;  ///< LF's A to D, then LH's
  GaitParameters parameters;
};

/// Fits the models to all limbs and phases, in the control points of a scale: the K scaling
/// coefficients of the contour at that scale (publication, (2.8) and section 4.2), in units of the
/// drawing; at the finest scale, the points themselves. Coefficients that move by less than 1 % of
/// the foot's excursion have no gamma of their own.
/// Throws as analyse_cycle does, and std::invalid_argument for outlines whose number of points is
/// no power of two, a scale that is none from 4 to that number, a phase without a complete run or
/// without a frame inside, no model, and key frames that are outside the record, equal, or half a
/// period apart or more.
GaitFit fit_gait(const LimbTracks& tracks, const GaitFitOptions& options);

}  // namespace wavecurve::gait
