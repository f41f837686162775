#pragma once

#include <memory>

#include <Eigen/Core>

#include "wavecurve/dynamics/lagrange_system.hpp"
#include "wavecurve/dynamics/modal/detail/modal_basis.hpp"
#include "wavecurve/operators/multiscale_operator.hpp"

namespace wavecurve::dynamics {

/// gram G + stiffness K of a system, applied in O(samples) without being assembled. One object per
/// thread.
class SystemOperator {
 public:
  SystemOperator(const LagrangeSystem& system, double gram, double stiffness);

  /// y = operator * x, samples x coordinates.
  void apply(const Eigen::Ref<const Eigen::MatrixXd>& x, Eigen::Ref<Eigen::MatrixXd> y);
  /// The entries of the diagonal.
  const Eigen::VectorXd& diagonal() const { return diagonal_; }
  /// Additions and multiplications of one application to one coordinate: the sums of products of
  /// two transforms and of the circulant.
  long long operations() const { return operations_; }

 private:
  MultiscaleOperator operator_;
  Eigen::VectorXd diagonal_;
  long long operations_ = 0;
};

/// G^-1 K, matrix-free. For an orthonormal bank that is K, in O(samples); for a biorthogonal one
/// S^-1 T_G^-1 T_K S, where the Fourier transform divides the circulants, in O(samples log
/// samples).
class ReducedStiffness {
 public:
  explicit ReducedStiffness(const LagrangeSystem& system);

  void apply(const Eigen::Ref<const Eigen::MatrixXd>& x, Eigen::Ref<Eigen::MatrixXd> y);
  long long operations() const;  ///< as SystemOperator's

 private:
  std::unique_ptr<SystemOperator> stiffness_;  ///< of an orthonormal bank
  std::unique_ptr<ModalBasis> fourier_;        ///< of a biorthogonal one
};

}  // namespace wavecurve::dynamics
