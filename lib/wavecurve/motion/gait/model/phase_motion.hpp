#pragma once

#include <array>
#include <optional>
#include <string_view>

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"

namespace wavecurve::gait {

/// How control points go from a key frame to the next. All pass through both.
enum class GaitModel {
  linear,
  quadratic,           ///< the publication's, a gamma for each coefficient
  quadratic_by_limb,   ///< one gamma for all coefficients of a limb
  quadratic_by_level,  ///< one gamma for each band of a wavelet transform of the control points
  cubic,
  quartic,
  quintic,
  sextic,
  oscillator,  ///< (3.16) itself, a pair of constants for each coefficient
  fourier,     ///< periodic, one series for the whole cycle
};

inline constexpr std::array gait_models{GaitModel::linear,
                                        GaitModel::quadratic,
                                        GaitModel::quadratic_by_limb,
                                        GaitModel::quadratic_by_level,
                                        GaitModel::cubic,
                                        GaitModel::quartic,
                                        GaitModel::quintic,
                                        GaitModel::sextic,
                                        GaitModel::oscillator,
                                        GaitModel::fourier};

/// "quadratic-by-limb" and the like.
std::string_view model_name(GaitModel model);
/// None for a text that names none.
std::optional<GaitModel> find_gait_model(std::string_view name);

/// Whether a model has so many rows of parameters.
bool has_rows(GaitModel model, Eigen::Index rows);

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
