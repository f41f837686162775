#pragma once

#include <vector>

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/operators/connection_coefficients.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve {

/// The matrix of multiscale_matrix, applied in O(samples) operations without being assembled:
/// y = S^T T S x, synthesis, circulant of the finest level, adjoint of the synthesis. Holds about
/// four vectors of workspace, so that apply allocates nothing; one object per thread.
class MultiscaleOperator {
 public:
  /// Throws as multiscale_matrix does, but has no bound on the non-zeros.
  MultiscaleOperator(const FilterBank<double>& bank, Eigen::Index samples, int levels, int p = 1,
                     int q = 1);
  MultiscaleOperator(const FilterBank<double>& bank,
                     const ConnectionCoefficients<double>& coefficients, Eigen::Index samples,
                     int levels);

  Eigen::Index size() const { return transform_.samples(); }

  /// y = operator * x; x and y must not overlap. Throws std::invalid_argument for a wrong size.
  void apply(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> y);

 private:
  void apply_circulant();

  PeriodicTransform<double> transform_;
  int sign_;                           ///< of mu_{-l} relative to mu_l
  std::vector<double> weights_;        ///< scaled mu_l, l = 0, 1, ...
  std::vector<double> window_;         ///< inputs of a block that wraps around
  Eigen::VectorXd samples_, product_;  ///< S x and T S x
  Eigen::VectorXd workspace_;
};

}  // namespace wavecurve
