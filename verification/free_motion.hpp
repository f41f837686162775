#pragma once

#include <Eigen/Core>

namespace wavecurve::verification {

/// The constants of rho q'' + C q' + K q = 0 with the Rayleigh damping C = s_1 rho I + s_2 K of
/// (3.5).
struct Material {
  double rho = 1, s1 = 0, s2 = 0;
};

/// q(tau) of the scalar equation rho q'' + c q' + k q = 0 in closed form, for rho > 0 and any
/// damping: below, at and above the critical one.
double free_oscillation(double rho, double c, double k, double q0, double velocity, double tau);

/// The exact free motion from q(0) = start at rest, one column an instant: each eigenvector of the
/// symmetric K moves by itself. Publication, (3.3) with Q_e = 0.
Eigen::MatrixXd free_motion(const Eigen::Ref<const Eigen::MatrixXd>& stiffness,
                            const Material& material,
                            const Eigen::Ref<const Eigen::VectorXd>& start,
                            const Eigen::Ref<const Eigen::VectorXd>& instants);

}  // namespace wavecurve::verification
