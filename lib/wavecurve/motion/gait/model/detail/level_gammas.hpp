#pragma once

#include <Eigen/Core>

#include "wavecurve/motion/gait/model/detail/fit_gammas.hpp"
#include "wavecurve/motion/gait/model/fit_models.hpp"

namespace wavecurve::gait {

/// A gamma for each band of the wavelet transform of the control points, down to four of them, with
/// the bank of the setting.
Gammas fit_level_gammas(const PhaseData& data, const ModelSetting& setting);

/// What such gammas, in one row, make of a movement q_1 - q_2: the row of a polynomial of degree 2.
/// A gamma that is NaN bends nothing.
Eigen::MatrixXd level_bend(const Eigen::MatrixXd& gamma, const Eigen::RowVectorXd& difference,
                           const ModelSetting& setting);

}  // namespace wavecurve::gait
