#include "verification/study/free_motion.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "wavecurve/dynamics/modal/oscillator.hpp"

namespace wavecurve::verification {

Eigen::MatrixXd free_motion(const Eigen::Ref<const Eigen::MatrixXd>& stiffness,
                            const dynamics::Material& material,
                            const Eigen::Ref<const Eigen::VectorXd>& start,
                            const Eigen::Ref<const Eigen::VectorXd>& instants) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness);
  const Eigen::VectorXd amplitudes = modes.eigenvectors().transpose() * start;
  Eigen::MatrixXd modal(start.size(), instants.size());
  for (Eigen::Index mode = 0; mode < start.size(); ++mode) {
    const double k = std::max(0.0, modes.eigenvalues()(mode));  // rounding may leave less than 0
    const double c = material.mass_damping * material.density + material.stiffness_damping * k;
    for (Eigen::Index i = 0; i < instants.size(); ++i) {
      modal(mode, i) =
          dynamics::propagator({material.density, c, k}, instants(i)).qq * amplitudes(mode);
    }
  }
  return modes.eigenvectors() * modal;
}

}  // namespace wavecurve::verification
