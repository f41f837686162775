#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "wavecurve/dynamics/solver.hpp"

namespace wavecurve::verification {

/// What solvers are compared on: a shape released at rest (released()), density and stiffness 1, t
/// from 0 to 1.
struct StudySetting {
  std::string filter = "db4";  ///< a name or a file, see io/load_filter.hpp
  Eigen::Index samples = 64;
  int levels = 6;
  std::string shape = "ellipse";  ///< a name or a file, see shape_of
  double mass_damping = 0, stiffness_damping = 0;

  friend bool operator==(const StudySetting&, const StudySetting&) = default;
};

/// Errors against the exact solution of the coupled system, see motion_error.hpp: the largest of 41 equally
/// spaced times, and at the last.
struct StudyErrors {
  double displacement_l2_max = 0, displacement_l2_final = 0;
  double maximum_norm_max = 0, maximum_norm_final = 0;
  double velocity_l2_max = 0, velocity_l2_final = 0;
  double energy_norm_max = 0, energy_norm_final = 0;
  double energy_drift = 0;
};

/// A solver at a tolerance, in a setting.
struct StudyPoint {
  StudySetting setting;
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
  std::string fingerprint;
};

/// The product of all lists.
struct StudyPlan {
  std::vector<StudySetting> settings;
  std::vector<std::string> solvers;
};

/// The times of model_errors.
Eigen::VectorXd study_times();

/// The accuracies that a solver is swept over, from coarse to fine; one empty of a closed form.
std::vector<std::optional<double>> sweep(const dynamics::NamedSolver& solver);

/// What a run takes up and tells.
struct StudyHooks {
  /// Points of an earlier run: those that the plan asks for, of the same fingerprint, are not
  /// computed again.
  std::vector<StudyPoint> known;
  /// Called with each computed point as soon as it is there, never by two threads at once.
  std::function<void(const StudyPoint&)> finished;
  /// Called with the numbers of points that are there and of all, never by two threads at once.
  std::function<void(std::size_t, std::size_t)> progress;
};

/// All points, setting by setting, solver by solver, from coarse to fine, computed on all cores.
/// What a solver throws becomes its point's failure, unless the machine lacked something
/// (std::bad_alloc, std::system_error): such a point is not finished, all others are, and then
/// std::runtime_error names it. Throws std::invalid_argument for an unknown solver, filter or shape,
/// sizes that do not fit, or a shape that is the circle, before anything is computed; what a hook
/// throws ends the run.
std::vector<StudyPoint> run_study(const StudyPlan& plan, const StudyHooks& hooks = {});

}  // namespace wavecurve::verification
