#pragma once

#include <Eigen/Core>

#include "wavecurve/motion/gait/model/phase_data.hpp"

namespace wavecurve::gait {

/// e_0 / rho and f_0 / rho, both at least 0, of each coefficient whose movement is at least the
/// given one (else NaN): the rows of PhaseMotion's `oscillator`. Nonlinear least squares of
/// q_2 + (q_1 - q_2) f(tau) by Levenberg and Marquardt, from the start or, where none is given,
/// from an oscillator that swings by a quarter; multiplying rho, e_0 and f_0 by a factor changes
/// nothing, so rho is 1.
Eigen::MatrixXd fit_oscillator(const PhaseData& data, double least_movement,
                               const Eigen::MatrixXd& start = {});

}  // namespace wavecurve::gait
