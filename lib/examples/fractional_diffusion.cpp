// Fractional diffusion u_t = -(-d^2/dx^2)^(3/4) u on a period, u = exp(sin 2 pi x) at first, by Galerkin's method; the operator's
// coefficients are proved. Prints the distance from the spectral solution at t = 0.01 with 16, 32, 64 and 128 coefficients, whose
// order is N for N vanishing moments:
//   db3: 3.9e-03 4.9e-04 6.2e-05 7.7e-06, order 3.0 +- 0.0
//   db4: 1.2e-03 8.0e-05 5.1e-06 3.2e-07, order 4.0 +- 0.0
//   db5: 4.7e-04 1.6e-05 5.3e-07 1.7e-08, order 4.9 +- 0.1
#include <wavecurve/certified.hpp>

#include "galerkin.hpp"

namespace certified = wavecurve::certified;

static constexpr double order = 1.5, end_time = 0.01;

static double start(double x) { return std::exp(std::sin(2 * std::numbers::pi * x)); }

/// By the symbol |2 pi k|^order of every frequency.
static Eigen::VectorXd spectral_solution(Eigen::Index n) {
  const auto points = Eigen::VectorXd::NullaryExpr(
      n, [&](Eigen::Index i) { return start(static_cast<double>(i) / static_cast<double>(n)); });
  Eigen::VectorXcd u = galerkin::fourier(points);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double frequency = 2 * std::numbers::pi * static_cast<double>(std::min(k, n - k));
    u[k] *= std::exp(-end_time * std::pow(frequency, order));
  }
  return galerkin::inverse_fourier(u);
}

/// The eigenvalues of the operator in shifts of phi. Derivatives from either side, which have the symbols (i x)^s and
/// (-i x)^s, add up to 2 cos(pi s / 2) |x|^s.
static Eigen::VectorXd eigenvalues(const char* name, int count) {
  using certified::HomogeneousOperator;
  const auto r = certified::periodic_operator_coefficients(
      certified::find_filter(name),
      {HomogeneousOperator::Kind::fractional, certified::Rational(3, 2)}, count, 60);
  const auto column = Eigen::VectorXd::NullaryExpr(count, [&](Eigen::Index l) {
    const int i = static_cast<int>(l);
    return (r[i] + r[(count - i) % count]).to_double();
  });
  const double both_sides = 2 * std::cos(std::numbers::pi * order / 2);
  return std::pow(count, order) / both_sides * galerkin::fourier(column).real();
}

int main() {
  const std::vector<int> counts{16, 32, 64, 128};
  for (const char* name : {"db3", "db4", "db5"}) {
    const auto bank = wavecurve::find_filter_bank(name);
    const auto phi = wavecurve::scaling_values(bank, 8),
               coarse_phi = wavecurve::scaling_values(bank, 3);
    std::vector<double> errors;
    for (const int count : counts) {
      Eigen::VectorXcd c = galerkin::fourier(galerkin::project(phi, count, 1, start));
      c.array() *= (-end_time * eigenvalues(name, count).array()).exp();
      const Eigen::VectorXd u = galerkin::values(coarse_phi, galerkin::inverse_fourier(c));
      errors.push_back((u - spectral_solution(u.size())).norm() / std::sqrt(u.size()));
    }
    galerkin::print_order(name, counts, errors);
  }
}
