#include "wavecurve/dynamics/modal/detail/exponential_difference.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wavecurve/elementary/exponential.hpp"

namespace wavecurve::dynamics {

namespace {

using Complex = std::complex<double>;

/// sinh(z) / z. Below |z| = 1/2 by its series, whose eighth term is below 2^-64 of the first.
Complex sinh_quotient(Complex z) {
  if (std::norm(z) >= 0.25) return hyperbolic_sine(z) / z;
  const Complex square = z * z;
  Complex sum = 1;
  for (int n = 7; n >= 1; --n) sum = 1.0 + square * sum / (2.0 * n * (2.0 * n + 1));
  return sum;
}

/// e^mean sum_n h_n(offsets) / (n + 2)!, h_n the complete homogeneous polynomial of three variables
/// with sum zero. Offsets below 1: |h_n| <= (n + 1)(n + 2) / 2, so 20 terms reach 2^-57 of the
/// first.
Complex difference_near(Complex mean, const std::array<Complex, 3>& offset) {
  // h_n = e_1 h_{n-1} - e_2 h_{n-2} + e_3 h_{n-3} with the elementary polynomials, e_1 = 0.
  const Complex e2 = offset[0] * offset[1] + offset[1] * offset[2] + offset[2] * offset[0];
  const Complex e3 = offset[0] * offset[1] * offset[2];
  std::array<Complex, 3> last = {1, 0, 0};  // h_n, h_{n-1}, h_{n-2}
  Complex sum = 0.5;
  double factorial = 2;
  for (int n = 1; n <= 20; ++n) {
    const Complex next = -e2 * last[1] + e3 * last[2];
    last = {next, last[0], last[1]};
    factorial *= n + 2;
    sum += next / factorial;
  }
  return exponential(mean) * sum;
}

}  // namespace

Complex exponential_difference(Complex x, Complex y) {
  // The larger exponential goes outside, so that nothing overflows: sinh(z) e^(x + y)/2 would.
  if (x.real() < y.real()) std::swap(x, y);
  const Complex half = 0.5 * (x - y);
  if (half.real() > 1) return exponential(x) * (1.0 - exponential(-2.0 * half)) / (2.0 * half);
  return exponential(0.5 * (x + y)) * sinh_quotient(half);
}

Complex exponential_difference(Complex x, Complex y, Complex z) {
  // The quotient is taken over the two points that are farthest apart.
  if (std::norm(x - y) > std::norm(x - z)) std::swap(y, z);
  if (std::norm(y - z) > std::norm(x - z)) std::swap(x, y);
  if (std::norm(x - z) < 1) {
    const Complex mean = (x + y + z) / 3.0;
    return difference_near(mean, {x - mean, y - mean, z - mean});
  }
  return (exponential_difference(x, y) - exponential_difference(y, z)) / (x - z);
}

double phi_function(int k, double x) {
  if (k == 0) return exponential(x);
  if (k == 1) return x == 0 ? 1 : exponential_minus_one(x) / x;
  if (std::abs(x) > 1) return (phi_function(k - 1, x) - (k == 2 ? 1 : 0.5)) / x;
  // sum_n x^n / (n + k)!; 18 terms reach 2^-57 of the first.
  double sum = 0;
  for (int n = 18; n >= 0; --n) sum = (1 + sum * x / (n + k + 1));
  return sum / (k == 2 ? 2 : 6);
}

}  // namespace wavecurve::dynamics
