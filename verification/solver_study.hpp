#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/dynamics/solver.hpp"

namespace wavecurve::verification {

/// What the solvers are compared on: a shape released at rest (released()), t from 0 to 1.
struct Study {
  LagrangeSystem system;
  Contour shape;
  std::vector<std::string> solvers;
};

/// Relative to the initial state, see motion_error.hpp; the largest of 41 equally spaced times, and
/// at the last. Of the exact solution of the coupled system.
struct StudyErrors {
  double displacement_l2_max = 0, displacement_l2_final = 0, energy_norm_max = 0;
};

/// A solver at a tolerance.
struct StudyPoint {
  std::string solver;
  /// What the solver was made with: a tolerance, or the step of one with fixed steps. None for a
  /// closed form, whose error is that of its model.
  std::optional<double> tolerance;
  std::optional<StudyErrors> errors;  ///< none of a failed solve
  Cost cost;
  double seconds = 0;   ///< the least of several runs
  std::string failure;  ///< empty: ok
};

/// The accuracies that a solver is swept over, from coarse to fine; one empty of a closed form.
std::vector<std::optional<double>> sweep(const NamedSolver& solver);

/// All points of all solvers. What a solver throws becomes its point's failure. progress is called
/// after each point with the number done and the number of all. Throws std::invalid_argument for an
/// unknown solver or a shape that is the circle, before anything is computed.
std::vector<StudyPoint> run_study(const Study& study,
                                  const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace wavecurve::verification
