#pragma once

#include <complex>
#include <optional>
#include <unsupported/Eigen/FFT>

#include <Eigen/Core>

#include "wavecurve/transform/detail/stockham_transform.hpp"

namespace wavecurve {

/// The discrete Fourier transform of any length. Of a power of two by StockhamTransform, of a long
/// one as a matrix (four steps: columns, twiddle factors, transposition, columns), whose columns
/// fit into the cache; of another length by Eigen's.
///   forward: X_k = sum_j x_j e^(-2 pi i j k / n),   inverse: its inverse.
class FourierTransform {
 public:
  using Vector = Eigen::VectorXcd;

  explicit FourierTransform(Eigen::Index size);

  void forward(Eigen::Ref<Vector> x);
  void inverse(Eigen::Ref<Vector> x);

 private:
  void transform(std::complex<double>* x, bool inverse);
  void by_eigen(std::complex<double>* x, bool inverse);
  void in_four_steps(std::complex<double>* x, bool inverse);

  Eigen::Index size_, rows_ = 1;  ///< rows_ = 2^shift_ > 1: in four steps
  Eigen::Index pitch_ = 0;
  int shift_ = 0;
  std::optional<StockhamTransform> of_columns_, of_rows_;  ///< lengths size / rows_ and rows_
  Vector buffer_, gathered_, coarse_, fine_;
  Eigen::FFT<double> fft_;
};

}  // namespace wavecurve
