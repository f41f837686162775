#pragma once

#include <Eigen/Core>

#include "wavecurve/dynamics/modal/oscillator.hpp"

namespace wavecurve::gait {

/// tau (1 - tau) P_k(2 tau - 1), k = 0 .. size - 1, P_k Legendre's polynomials: zero at both ends,
/// and a better condition than powers have.
Eigen::VectorXd bridge_basis(double tau, Eigen::Index size);
/// The derivative by tau.
Eigen::VectorXd bridge_slope(double tau, Eigen::Index size);

/// 1, cos 2 pi u, sin 2 pi u, cos 4 pi u, ...; size is odd.
Eigen::VectorXd fourier_basis(double u, Eigen::Index size);
/// The derivative by u.
Eigen::VectorXd fourier_slope(double u, Eigen::Index size);

/// f - 1 + tau for the f with f'' + e f' + k f = 0, f(0) = 1, f(1) = 0; publication, (3.16).
class OscillatorDeviation {
 public:
  /// Throws as propagator does.
  OscillatorDeviation(double e, double k);

  double value(double tau) const;
  double slope(double tau) const;

 private:
  dynamics::Oscillator oscillator_;
  double start_;  ///< f'(0)
};

}  // namespace wavecurve::gait
