#pragma once

#include <Eigen/Core>

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::verification {

// How far a solution is from the exact one, one number a time. All but displacement_errors and
// maximum_errors need the velocities.

/// L2 norms over the parameter of the curve of the displacement's error, relative to that of the
/// initial displacement: sqrt(sum_j e_j^T G e_j), G the Gram matrix, j = x, y.
Eigen::VectorXd displacement_errors(const dynamics::InitialValueProblem& problem,
                                    const dynamics::Trajectory& solution,
                                    const dynamics::Trajectory& exact);

/// The largest distance between two sample points, relative to the largest initial displacement of
/// a sample point. For plane curves only.
Eigen::VectorXd maximum_errors(const dynamics::InitialValueProblem& problem,
                               const dynamics::Trajectory& solution,
                               const dynamics::Trajectory& exact);

/// L2 norms of the velocity's error, relative to the largest of the exact velocity.
Eigen::VectorXd velocity_errors(const dynamics::InitialValueProblem& problem,
                                const dynamics::Trajectory& solution,
                                const dynamics::Trajectory& exact);

/// Energy norms, sqrt(sum_j e'_j^T M e'_j + e_j^T K e_j), relative to that of the initial state.
Eigen::VectorXd energy_errors(const dynamics::InitialValueProblem& problem,
                              const dynamics::Trajectory& solution,
                              const dynamics::Trajectory& exact);

/// The total energy, 1/2 sum_j v_j^T M v_j + q_j^T K q_j, relative to that of the initial state. M
/// and K are those of the coupled system, whatever the model of the solver.
Eigen::VectorXd energies(const dynamics::InitialValueProblem& problem,
                         const dynamics::Trajectory& solution);

/// What the energy of a free motion does that it should not: undamped its largest change since the
/// start, damped its largest increase from one time to the next.
double energy_drift(const dynamics::InitialValueProblem& problem,
                    const dynamics::Trajectory& solution);

}  // namespace wavecurve::verification
