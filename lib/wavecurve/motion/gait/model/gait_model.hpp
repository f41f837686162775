#pragma once

#include <span>
#include <string_view>

#include <Eigen/Core>

namespace wavecurve::gait {

/// How control points go from a key frame to the next. All pass through both. What each is stands
/// in one row of the table in gait_model.cpp.
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

/// All of them.
extern const std::span<const GaitModel> gait_models;

/// "quadratic-by-limb" and the like.
std::string_view model_name(GaitModel model);

/// Throws std::invalid_argument for a text that names none, naming those there are.
GaitModel find_gait_model(std::string_view name);

/// Whether a model has so many rows of parameters.
bool has_rows(GaitModel model, Eigen::Index rows);

}  // namespace wavecurve::gait
