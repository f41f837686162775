#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::verification {

/// What solvers are compared on: a shape released at rest (released()), density and stiffness 1, t
/// from 0 to 1.
struct StudySetting {
  std::string filter = "db4";  ///< a name or a file, see io/load_filter.hpp
  Eigen::Index samples = 64;
  int levels = 6;
  std::string shape = "ellipse";  ///< a name or a file, see shape_of
  double mass_damping = 0, stiffness_damping = 0;

  friend auto operator<=>(const StudySetting&, const StudySetting&) = default;
};

/// The setting of a point of which nothing else is said.
std::shared_ptr<const StudySetting> default_setting();

/// Errors against the exact solution of the coupled system, see motion_error.hpp: the largest of 41 equally
/// spaced times, and at the last.
struct StudyErrors {
  double displacement_l2_max = 0, displacement_l2_final = 0;
  double maximum_norm_max = 0, maximum_norm_final = 0;
  double velocity_l2_max = 0, velocity_l2_final = 0;
  double energy_norm_max = 0, energy_norm_final = 0;
  double energy_drift = 0;

  friend bool operator==(const StudyErrors&, const StudyErrors&) = default;
};

/// A solver at a tolerance, in a setting. There may be millions of them.
struct StudyPoint {
  std::shared_ptr<const StudySetting> setting = default_setting();  ///< shared by its points
  std::string solver;
  /// What the solver was made with: a tolerance, or the step of one with fixed steps. None for a
  /// closed form, whose error is that of its model.
  std::optional<double> tolerance;
  std::optional<StudyErrors> errors;  ///< none of a failed solve
  /// The displacement's L2 error at each of the times, of closed forms only.
  std::vector<double> model_errors;
  dynamics::Cost cost;
  double seconds = 0;   ///< processor time of the solving thread, the least of several runs
  std::string failure;  ///< empty: ok
  /// A fingerprint of the numbers that the problem consists of: the same setting may name a changed file.
  std::uint64_t fingerprint = 0;
};

/// "coupled at 1e-06 (filter db4, 64 samples, 6 levels, shape star, damping 0, 0.1)", for a message.
std::string name_of(const StudyPoint& point);

}  // namespace wavecurve::verification
