#pragma once

#include <Eigen/Core>

#include "wavecurve/dynamics/lagrange_system.hpp"

namespace wavecurve::verification {

/// The exact free motion of density q'' + C q' + K q = 0, C = mass_damping density I +
/// stiffness_damping K (3.5), from q(0) = start at rest, one column an instant: each eigenvector of
/// the given symmetric, positive semi-definite K moves on its own. Only these three constants of the
/// material count. Publication, (3.3) with Q_e = 0.
Eigen::MatrixXd free_motion(const Eigen::Ref<const Eigen::MatrixXd>& stiffness,
                            const dynamics::Material& material,
                            const Eigen::Ref<const Eigen::VectorXd>& start,
                            const Eigen::Ref<const Eigen::VectorXd>& instants);

}  // namespace wavecurve::verification
