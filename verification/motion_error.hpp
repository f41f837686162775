#pragma once

#include <Eigen/Core>

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::verification {

/// L2 norms over the parameter of the curve of the displacement's error, one a time, relative to
/// that of the initial displacement: sqrt(sum_j e_j^T G e_j), G the Gram matrix, j = x, y.
Eigen::VectorXd displacement_errors(const InitialValueProblem& problem, const Trajectory& solution,
                                    const Trajectory& exact);

/// The same in the energy norm, sqrt(sum_j e'_j^T M e'_j + e_j^T K e_j), relative to that of the
/// initial state. Needs the velocities.
Eigen::VectorXd energy_errors(const InitialValueProblem& problem, const Trajectory& solution,
                              const Trajectory& exact);

}  // namespace wavecurve::verification
