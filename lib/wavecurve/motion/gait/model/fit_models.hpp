#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/motion/gait/model/gait_parameters.hpp"
#include "wavecurve/motion/gait/model/phase_data.hpp"

namespace wavecurve::gait {

/// What fits of a limb take besides the data.
struct ModelSetting {
  FilterBank<double> bank;    ///< of the levels of quadratic_by_level, down to four control points
  double least_movement = 0;  ///< |q_1 - q_2| of a coefficient with a gamma or an oscillator
  int fourier_terms = 9;      ///< odd
  Eigen::Index foot = 0;      ///< control point
};

struct ModelFit {
  PhaseMotion motion;
  /// Root mean squares over frames and coefficients, in units of length; see FitQuality.
  double residual = 0, cross_validated = 0;
  double foot_residual = 0;  ///< of the foot's x alone
};

/// One model of one of a limb's phases, fitted to all runs, and cross-validated.
ModelFit fit_model(GaitModel model, const std::vector<PhaseData>& phases, std::size_t phase,
                   const ModelSetting& setting);

/// The publication's gammas of a phase: by coefficient, by limb, by level.
PhaseGammas phase_gammas(const PhaseData& data, const ModelSetting& setting);

}  // namespace wavecurve::gait
