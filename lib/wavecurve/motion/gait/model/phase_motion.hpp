#pragma once

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/motion/gait/model/gait_model.hpp"

namespace wavecurve::gait {

/// The motion from a key frame q_1 at tau = 0 to the next, q_2, at tau = 1. A coefficient is one
/// coordinate of one control point; there are 2 K of them, the x of all K points before the y.
///
///   q(tau) = q_2 + (q_1 - q_2) (1 - tau) + D(tau),   D(0) = D(1) = 0
///
/// Parameters hold one column a coefficient. Their rows, and D:
///   linear      none;                          D = 0
///   quadratic   gamma, NaN where there is none;
///               D = (q_1 - q_2) gamma (tau^2 - tau), so that q = q_2 + (q_1 - q_2) f with the
///               publication's f(tau) = 1 - (1 + gamma) tau + gamma tau^2 (section 4.2)
///               (quadratic and quadratic_by_limb)
///   degree d    c_0 .. c_{d-2};  D = tau (1 - tau) sum_k c_k P_k(2 tau - 1), P_k Legendre's
///               quadratic_by_level is of degree 2: what the gammas of the bands make of the mean
///               key frames. In units of length, so that points whose key frames coincide move too
///   oscillator  e_0 / rho, f_0 / rho, NaN where there are none;  D = (q_1 - q_2) (f - 1 + tau),
///               f'' + (e_0 / rho) f' + (f_0 / rho) f = 0, f(0) = 1, f(1) = 0: (3.16), with the
///               constants a, b that the key frames ask for. Only the ratios matter.
///   fourier     a_0, a_1, b_1, a_2, b_2, ...; F(u) = a_0 + sum_h a_h cos 2 pi h u + b_h sin 2 pi h
///               u at u = begin + tau (end - begin); D = F less the line between its ends
struct PhaseMotion {
  GaitModel model = GaitModel::linear;
  Eigen::MatrixXd parameters;
  double begin = 0, end = 1;  ///< of the phase, as shares of the cycle; for the series only
};

/// The contour at tau. Throws std::invalid_argument unless the parameters have a column for each
/// coefficient of both key frames.
Contour pose_between(const PhaseMotion& motion, const Contour& from, const Contour& to, double tau);

/// The derivative by tau.
Contour velocity_between(const PhaseMotion& motion, const Contour& from, const Contour& to,
                         double tau);

}  // namespace wavecurve::gait
