#include "wavecurve/curves/detail/contour_spectrum.hpp"

#include <cmath>
#include <complex>
#include <stdexcept>

#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/transform/fourier_transform.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;
using Eigen::VectorXcd;

std::complex<double> unit(double angle) { return {cosine(angle), sine(angle)}; }

double angle_of(const std::complex<double>& z) {
  return z == 0.0 ? 0 : arctangent(z.imag(), z.real());
}

}  // namespace

VectorXcd contour_spectrum(const Contour& points) {
  VectorXcd z(points.rows());
  z.real() = points.col(0);
  z.imag() = points.col(1);
  FourierTransform(z.size()).forward(z);
  return z / static_cast<double>(z.size());
}

Contour contour_of_spectrum(const VectorXcd& spectrum) {
  VectorXcd z = spectrum * static_cast<double>(spectrum.size());
  FourierTransform(z.size()).inverse(z);
  Contour points(z.size(), 2);
  points.col(0) = z.real();
  points.col(1) = z.imag();
  return points;
}

VectorXcd moved(const VectorXcd& spectrum, double shift, double angle) {
  const Index size = spectrum.size();
  VectorXcd result(size);
  for (Index i = 0; i < size; ++i) {
    const auto k = static_cast<double>(frequency(i, size));
    const bool is_highest = 2 * i == size;
    const std::complex<double> factor = is_highest ? cosine(k * shift) : unit(k * shift);
    result[i] = unit(angle) * factor * spectrum[i];
  }
  return result;
}

VectorXcd without_place_and_size(VectorXcd spectrum) {
  const double mean = std::abs(spectrum[0]);
  spectrum[0] = 0;
  const double size = spectrum.norm();
  // So much rounding leaves of points that are one.
  if (!(size > 1e-13 * mean) || !std::isfinite(size)) {
    throw std::invalid_argument("a shape has a size, but its points are all one");
  }
  return spectrum / size;
}

FirstEllipse first_ellipse(const VectorXcd& spectrum) {
  const double forward = angle_of(spectrum[1]);
  const double backward = angle_of(spectrum[spectrum.size() - 1]);
  return {(backward - forward) / 2, -(forward + backward) / 2};
}

}  // namespace wavecurve
