#pragma once

#include "wavecurve/dynamics/modal/detail/modal_basis.hpp"
#include "wavecurve/dynamics/modal/oscillator.hpp"

namespace wavecurve::dynamics {

/// Amplitudes of displacement and velocity of all modes.
struct ModalState {
  ModalCoefficients displacement, velocity;
};

/// The constants of one mode.
Oscillator oscillator(const CirculantEigenvalues& modes, Eigen::Index mode);

/// The propagators of all modes over a time, mode by mode in arrays.
class ModalPropagator {
 public:
  ModalPropagator() = default;
  /// For displacements that start at rest, without force and without velocities, a sixth of the
  /// memory is enough; of a million modes, the memory is what takes the time.
  ModalPropagator(const CirculantEigenvalues& modes, double t, bool from_displacement_only = false);

  /// First this, then other: over the sum of their times.
  ModalPropagator then(const ModalPropagator& other) const;

  /// The state after the time, with a constant force; of the velocities, only if wanted. An empty
  /// force or velocity is zero.
  ModalState advance(const ModalBasis& basis, const ModalState& state,
                     const ModalCoefficients& force, bool velocities) const;
  /// The same, in the memory of the displacement.
  ModalState advance(const ModalBasis& basis, ModalCoefficients displacement,
                     const ModalCoefficients& velocity, const ModalCoefficients& force,
                     bool velocities) const;

 private:
  Eigen::ArrayXd qq_, qv_, vq_, vv_, qf_, vf_;
};

}  // namespace wavecurve::dynamics
