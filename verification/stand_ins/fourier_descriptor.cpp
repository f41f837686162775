#include "verification/stand_ins/fourier_descriptor.hpp"

#include <unsupported/Eigen/FFT>

namespace wavecurve::verification {

Contour fourier_approximation(const Contour& samples, Eigen::Index size) {
  const Eigen::Index count = samples.rows();
  Eigen::VectorXcd z(count), spectrum;
  z.real() = samples.col(0);
  z.imag() = samples.col(1);
  Eigen::FFT<double> fft;
  fft.fwd(spectrum, z);
  const Eigen::Index positive = (size + 1) / 2, negative = size / 2;
  spectrum.segment(positive, count - positive - negative).setZero();
  fft.inv(z, spectrum);
  Contour result(count, 2);
  result << z.real(), z.imag();
  return result;
}

}  // namespace wavecurve::verification
