#include "wavecurve/curves/interpolation.hpp"

#include <complex>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/transform/dyadic_values.hpp"
#include "wavecurve/transform/fourier_transform.hpp"
#include "wavecurve/transform/plain_transform.hpp"

namespace wavecurve {

namespace {

constexpr double smallest_modulus = 1e-6;

/// phi at the integers with period `samples`: the first column of the circulant.
Eigen::VectorXd circulant_of_phi(const FilterBank<double>& bank, Eigen::Index samples) {
  const DyadicValues phi = scaling_values(bank, 0);
  const Filter<double> values{static_cast<int>(phi.first), {phi.values.begin(), phi.values.end()}};
  return plain::periodized(values, samples);
}

Eigen::VectorXcd symbol_of_phi(const FilterBank<double>& bank, Eigen::Index samples) {
  Eigen::VectorXcd symbol = circulant_of_phi(bank, samples).cast<std::complex<double>>();
  FourierTransform(samples).forward(symbol);
  return symbol;
}

/// Both columns in one: z = x + i y, since the circulants are real.
template <class Operation>
Contour in_frequency(const Contour& points, Operation operation) {
  Eigen::VectorXcd z(points.rows());
  z.real() = points.col(0);
  z.imag() = points.col(1);
  FourierTransform fourier(points.rows());
  fourier.forward(z);
  operation(z);
  fourier.inverse(z);
  Contour result(points.rows(), 2);
  result << z.real(), z.imag();
  return result;
}

}  // namespace

Contour values_at_integers(const FilterBank<double>& bank, const Contour& finest) {
  const Eigen::VectorXcd symbol = symbol_of_phi(bank, finest.rows());
  return in_frequency(finest, [&](Eigen::VectorXcd& z) { z.array() *= symbol.array(); });
}

Contour interpolate(const FilterBank<double>& bank, const Contour& points) {
  const Eigen::VectorXcd symbol = symbol_of_phi(bank, points.rows());
  const double modulus = symbol.cwiseAbs().minCoeff();
  if (!(modulus >= smallest_modulus)) {
    throw std::domain_error(fmt::format(
        "{}: no curve through the points: the smallest modulus of phi's symbol at {} points is "
        "{:.3g}, but must be at least {:g}",
        bank.name, points.rows(), modulus, smallest_modulus));
  }
  return in_frequency(points, [&](Eigen::VectorXcd& z) { z.array() /= symbol.array(); });
}

double smallest_symbol(const FilterBank<double>& bank, Eigen::Index samples) {
  return symbol_of_phi(bank, samples).cwiseAbs().minCoeff();
}

}  // namespace wavecurve
