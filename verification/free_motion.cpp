#include "free_motion.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Eigenvalues>

namespace wavecurve::verification {

double free_oscillation(double rho, double c, double k, double q0, double velocity, double tau) {
  if (!(rho > 0)) throw std::domain_error("rho is " + std::to_string(rho) + ", not above 0");
  const double decay = c / (2 * rho);
  const double discriminant = k / rho - decay * decay;
  const double start_slope = velocity + decay * q0;
  const double frequency = std::sqrt(std::abs(discriminant));
  if (discriminant > 0) {
    return std::exp(-decay * tau) *
           (q0 * std::cos(frequency * tau) + start_slope * std::sin(frequency * tau) / frequency);
  }
  if (frequency == 0) return std::exp(-decay * tau) * (q0 + start_slope * tau);
  // Both exponents are at most 0 for c, k >= 0, so that neither exponential can overflow; expm1
  // keeps the digits of their difference near the critical damping.
  const double slow = std::exp((frequency - decay) * tau);
  const double fast = std::exp(-(frequency + decay) * tau);
  const double difference = -slow * std::expm1(-2 * frequency * tau);
  return q0 * (slow + fast) / 2 + start_slope * difference / (2 * frequency);
}

Eigen::MatrixXd free_motion(const Eigen::Ref<const Eigen::MatrixXd>& stiffness,
                            const Material& material,
                            const Eigen::Ref<const Eigen::VectorXd>& start,
                            const Eigen::Ref<const Eigen::VectorXd>& instants) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness);
  const Eigen::VectorXd amplitudes = modes.eigenvectors().transpose() * start;
  Eigen::MatrixXd modal(start.size(), instants.size());
  for (Eigen::Index mode = 0; mode < start.size(); ++mode) {
    const double k = modes.eigenvalues()(mode);
    const double c = material.s1 * material.rho + material.s2 * k;
    for (Eigen::Index i = 0; i < instants.size(); ++i) {
      modal(mode, i) = free_oscillation(material.rho, c, k, amplitudes(mode), 0, instants(i));
    }
  }
  return modes.eigenvectors() * modal;
}

}  // namespace wavecurve::verification
