#pragma once

#include <memory>

#include <Eigen/Core>

namespace wavecurve {

/// The discrete Fourier transform of any length n, in place:
///   forward: X_k = sum_j x_j e^(-2 pi i j k / n),   inverse: its inverse, with the factor 1 / n.
/// The transform of a power of two is done by Stockham's algorithm, of a long one as a matrix (four steps: columns,
/// twiddle factors, transposition, columns), whose columns fit into the cache; of another length as a
/// convolution with a chirp (Bluestein), of powers of two. Nothing is allocated after construction, and the
/// results have the same bits on every processor. The transform has buffers of
/// its own: one for each thread.
class FourierTransform {
 public:
  using Vector = Eigen::VectorXcd;

  explicit FourierTransform(Eigen::Index size);
  FourierTransform(FourierTransform&&) noexcept;
  FourierTransform& operator=(FourierTransform&&) noexcept;
  ~FourierTransform();

  /// x has the length given.
  void forward(Eigen::Ref<Vector> x);
  void inverse(Eigen::Ref<Vector> x);

 private:
  class Steps;

  std::unique_ptr<Steps> steps_;
};

}  // namespace wavecurve
