#pragma once

#include <memory>

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// The discrete periodic wavelet transform (DPWT) of a bank, any number of levels, any length that
/// 2^levels divides, also shorter than the filters. Coefficients are in global-to-local order (see
/// Band). Equal to plain::forward_transform and plain::inverse_transform up to rounding.
///
/// forward is S^-1 and inverse is S, the synthesis matrix; the adjoints are S^-T and S^T. Each
/// column of the argument is a signal of its own: a vector, a matrix of any number of columns, or
/// blocks, rows and columns of one, with any strides. A column's result is the same to the last bit
/// in whatever company it is transformed. Output is the input's memory (and then its strides), or
/// none of it.
///
/// Nothing is allocated after construction: the caller lends a workspace of workspace_size()
/// values, which overlaps neither. (A whole matrix in row-major order is an Eigen::Map with strides
/// to us; where one is given as the input, Eigen makes a copy.) Sizes are checked
/// (std::invalid_argument). Publication, section 2.1, (2.7)-(2.9).
template <class Scalar = double>
class PeriodicTransform {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Strides = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;
  using In = const Eigen::Ref<const Matrix, 0, Strides>&;
  using Out = Eigen::Ref<Matrix, 0, Strides>;
  using Workspace = Eigen::Ref<Eigen::Vector<Scalar, Eigen::Dynamic>>;

  /// Throws as multiscale_bands does.
  PeriodicTransform(const FilterBank<Scalar>& bank, Eigen::Index samples, int levels);

  Eigen::Index samples() const { return samples_; }
  int levels() const { return levels_; }
  Eigen::Index workspace_size(Eigen::Index columns = 1) const;

  void forward(In samples, Out coefficients, Workspace workspace) const;
  void inverse(In coefficients, Out samples, Workspace workspace) const;
  void forward_adjoint(In coefficients, Out samples, Workspace workspace) const;
  void inverse_adjoint(In samples, Out coefficients, Workspace workspace) const;

 private:
  struct Cascade;  ///< the filters, prepared for the kernels; immutable, so copies share it

  Eigen::Index samples_;
  int levels_;
  std::shared_ptr<const Cascade> cascade_;
};

}  // namespace wavecurve
