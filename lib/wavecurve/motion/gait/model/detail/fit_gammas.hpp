#pragma once

#include <vector>

#include <Eigen/Core>

#include "wavecurve/motion/gait/model/phase_data.hpp"

namespace wavecurve::gait {

/// The publication's gamma with what it is worth.
struct Gammas {
  Eigen::VectorXd gamma, standard_error;  ///< NaN where there is none
};

/// The gamma of each group of coefficients that minimises
///   sum (q - q_2 - (q_1 - q_2) f(tau))^2,   f(tau) = 1 - (1 + gamma) tau + gamma tau^2,
/// over the frames of all runs: with w = tau^2 - tau and e = q - q_2 - (q_1 - q_2) (1 - tau),
///   gamma = sum (q_1 - q_2) w e / sum (q_1 - q_2)^2 w^2,
/// in which a coefficient counts by the square of its movement. `group` gives the number of each
/// coefficient's group, 0 .. groups - 1. A group has no gamma, NaN, where its movement |q_1 - q_2|
/// is less, in the root mean square, than the given least one: it would be a division of nearly
/// nothing by nearly nothing.
///
/// The standard error is that of independent errors of equal variance s^2 in all points, those of
/// the key frames included, on which the errors of a whole run depend: residuals are
/// e_i = eps_i - f_i eps_1 - (1 - f_i) eps_2, so that to first order in eps
///   var gamma = s^2 sum_runs (q_1 - q_2)^2 (sum w^2 + (sum w f)^2 + (sum w (1 - f))^2)
///               / (sum (q_1 - q_2)^2 w^2)^2,
/// and s^2 is the sum of squared residuals by its expectation for s = 1. (Key frames that fall
/// between frames are interpolated, which lowers their variance a little.)
/// Publication, section 4.2; the normal equation of one unknown.
Gammas fit_gammas(const PhaseData& data, const Eigen::VectorXi& group, double least_movement);

/// Every coefficient is a group of its own; all are one.
Eigen::VectorXi each_coefficient(Eigen::Index coefficients);
Eigen::VectorXi all_coefficients(Eigen::Index coefficients);

}  // namespace wavecurve::gait
