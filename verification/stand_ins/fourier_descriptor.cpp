#include "verification/stand_ins/fourier_descriptor.hpp"

#include "wavecurve/transform/fourier_transform.hpp"

namespace wavecurve::verification {

Contour fourier_approximation(const Contour& samples, Eigen::Index size) {
  const Eigen::Index count = samples.rows();
  Eigen::VectorXcd z(count);
  z.real() = samples.col(0);
  z.imag() = samples.col(1);
  FourierTransform fourier(count);
  fourier.forward(z);
  const Eigen::Index positive = (size + 1) / 2, negative = size / 2;
  z.segment(positive, count - positive - negative).setZero();
  fourier.inverse(z);
  Contour result(count, 2);
  result << z.real(), z.imag();
  return result;
}

}  // namespace wavecurve::verification
