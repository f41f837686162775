#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/dynamics/lagrange_system.hpp"

namespace wavecurve::dynamics {

/// Amplitudes of independent modes, one a row; a column holds two coordinates as the real and the
/// imaginary part: every mode's equation is real, so they stay apart.
using ModalCoefficients = Eigen::MatrixXcd;

/// A basis in which a system, or what is kept of it, falls apart into one oscillator a row. Many
/// rows share their constants.
class ModalBasis {
 public:
  virtual ~ModalBasis() = default;

  /// The constants of the distinct modes, and which of them each row has.
  const CirculantEigenvalues& modes() const { return modes_; }
  Eigen::Index mode(Eigen::Index row) const { return mode_of_row_[static_cast<std::size_t>(row)]; }
  Eigen::Index rows() const { return static_cast<Eigen::Index>(mode_of_row_.size()); }

  ModalCoefficients forward(const Eigen::Ref<const Eigen::MatrixXd>& coefficients);
  Eigen::MatrixXd backward(ModalCoefficients spectrum, Eigen::Index coordinates);
  /// The operations of one forward or backward change of two coordinates, by formula.
  virtual long long operations() const = 0;

 protected:
  using In = const Eigen::Ref<const Eigen::VectorXd>&;
  using Out = Eigen::Ref<Eigen::VectorXd>;
  using Column = Eigen::Ref<Eigen::VectorXcd>;

  ModalBasis(CirculantEigenvalues modes, std::vector<int> mode_of_row);

 private:
  /// Changes two coordinates at once; from_modes uses up the modes.
  virtual void to_modes(In first, In second, Column modes) = 0;
  virtual void from_modes(Column modes, Out first, Out second) = 0;

  CirculantEigenvalues modes_;
  std::vector<int> mode_of_row_;
};

/// The finest level's Fourier basis, in which the system falls apart exactly.
std::unique_ptr<ModalBasis> fourier_basis(const LagrangeSystem& system);

/// The Fourier basis of each band: exact for the system without what couples the bands.
std::unique_ptr<ModalBasis> band_fourier_basis(const LagrangeSystem& system);

/// The multiscale basis itself: exact for the system without any off-diagonal entries.
std::unique_ptr<ModalBasis> coefficient_basis(const LagrangeSystem& system);

}  // namespace wavecurve::dynamics
