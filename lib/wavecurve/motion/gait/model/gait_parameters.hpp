#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/motion/gait/model/limb_path.hpp"

namespace wavecurve::gait {

/// How well a model fits a phase of a limb.
struct FitQuality {
  std::string limb, phase;
  GaitModel model = GaitModel::linear;
  /// Root mean square, over frames, control points and coordinates, of data less model, as a share
  /// of the stride length.
  double residual_share_of_stride = 0;
  /// The same of the cycles that a fit left out, each in its turn, its own key frames given; of one
  /// cycle alone, of every fifth frame. The periodic model gets no key frames.
  double cross_validated = 0;
  /// The error of the foot's fore-aft position alone, as a share of its excursion: the figure that others
  /// give. Along half a cosine, from rest to rest, a straight line leaves 0.075 of it.
  double foot_share_of_excursion = 0;
  int cycles = 0;
};

/// The publication's gammas of a phase of a limb. NaN where a coefficient hardly moves.
struct PhaseGammas {
  std::string limb, phase;
  Eigen::VectorXd gamma, standard_error;  ///< by coefficient
  double limb_gamma = 0, limb_standard_error = 0;
  Eigen::VectorXd level_gamma, level_standard_error;  ///< by band, coarse to fine
};

/// What a fitted gait is drawn from. Lengths in units of the tracks, y down.
struct GaitParameters {
  double period = 0;
  double facing = 1;  ///< 1: to larger x
  double stride = 0;  ///< the length by which the animal gets on in a cycle
  std::string filter;
  Eigen::Index samples = 0;  ///< points of an outline
  Eigen::Index scale = 0;    ///< control points of an outline
  /// Stance and swing by the chosen models, from touch-down on; offset: when it is, after LF's.
  std::vector<LimbPath> limbs;
  /// The publication's: subcycles A, B, C, D from two key frames, for the left limbs. Right limbs
  /// do the same half a cycle later.
  std::vector<LimbPath> subcycles;
  std::vector<PhaseGammas> gammas;
  std::vector<FitQuality> quality;
};

}  // namespace wavecurve::gait
