// What the programs that solve equations have in common. A function is a sum of phi_n(x) = phi(x / h - n), where h is
// the period divided by the number of coefficients.
#pragma once

#include <cmath>
#include <complex>
#include <cstdio>
#include <map>
#include <numbers>
#include <vector>
#include <wavecurve/wavecurve.hpp>

namespace galerkin {

/// sum_n c_n phi_n at the points i h / 2^level of a period, phi being given at that level.
inline Eigen::VectorXd values(const wavecurve::DyadicValues& phi, const Eigen::VectorXd& c) {
  const Eigen::Index fine = Eigen::Index{1} << phi.level, size = c.size() * fine;
  const auto first = static_cast<Eigen::Index>(phi.first);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(size);
  for (Eigen::Index n = 0; n < c.size(); ++n) {
    const Eigen::Index start = ((n + first) % c.size() + c.size()) * fine;
    for (Eigen::Index i = 0; i < phi.values.size(); ++i) {
      result[(start + i) % size] += c[n] * phi.values[i];
    }
  }
  return result;
}

/// The orthogonal projection: int f(x) phi_n(x) dx / h, as a sum over the points at which phi is given. It is
/// exact for polynomials of a degree below the vanishing moments.
template <class Function>
Eigen::VectorXd project(const wavecurve::DyadicValues& phi, int count, double period, Function f) {
  return Eigen::VectorXd::NullaryExpr(count, [&](Eigen::Index n) {
    double sum = 0;
    for (Eigen::Index i = 0; i < phi.values.size(); ++i) {
      sum += f(period / count * (static_cast<double>(n) + phi.point(i))) * phi.values[i];
    }
    return std::ldexp(sum, -phi.level);
  });
}

/// The root mean square of values at equidistant points of a period less those of f.
template <class Function>
double distance(const Eigen::VectorXd& u, double period, Function f) {
  const auto n = static_cast<double>(u.size());
  double sum = 0;
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    sum += std::pow(u[i] - f(period * static_cast<double>(i) / n), 2);
  }
  return std::sqrt(sum / n);
}

inline wavecurve::FourierTransform& transform_of(Eigen::Index size) {
  static std::map<Eigen::Index, wavecurve::FourierTransform> known;
  return known.try_emplace(size, size).first->second;
}

/// sum_l column_l e^(-2 pi i k l / n), k = 0 .. n - 1: the eigenvalues of a circulant matrix; and back.
inline Eigen::VectorXcd fourier(Eigen::VectorXcd column) {
  transform_of(column.size()).forward(column);
  return column;
}
inline Eigen::VectorXd inverse_fourier(Eigen::VectorXcd eigenvalues) {
  transform_of(eigenvalues.size()).inverse(eigenvalues);
  return eigenvalues.real();
}

/// (2 pi i k / period)^order, k = 0 .. n/2 - 1, -n/2 .. -1: what a derivative multiplies each frequency by. An odd one
/// has no place for the highest frequency, which is real.
inline Eigen::VectorXcd derivative_symbol(Eigen::Index n, double period, int order) {
  Eigen::VectorXcd symbol(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto signed_k = static_cast<double>(2 * k < n ? k : k - n);
    symbol[k] = std::pow(std::complex<double>(0, 2 * std::numbers::pi * signed_k / period), order);
  }
  if (order % 2 == 1 && n % 2 == 0) symbol[n / 2] = 0;
  return symbol;
}

/// A step of c' = slope(c) by the implicit midpoint rule, which keeps every quadratic invariant. The equation is
/// iterated until rounding ends the progress.
template <class Slope>
Eigen::VectorXd midpoint_step(const Eigen::VectorXd& c, double step, Slope slope) {
  Eigen::VectorXd middle = c;
  for (double change = HUGE_VAL, before = HUGE_VAL; change > 0; before = change) {
    const Eigen::VectorXd next = c + step / 2 * slope(middle);
    change = (next - middle).lpNorm<Eigen::Infinity>();
    if (change >= before) break;
    middle = next;
  }
  return 2 * middle - c;
}

/// Three such steps, which together are of fourth order (Yoshida 1990).
template <class Slope>
Eigen::VectorXd step_of_order_4(const Eigen::VectorXd& c, double step, Slope slope) {
  const double outer = step / (2 - std::cbrt(2.0));
  const Eigen::VectorXd first = midpoint_step(c, outer, slope);
  return midpoint_step(midpoint_step(first, step - 2 * outer, slope), outer, slope);
}

/// Steps of z' = symbol z + fourier(slope(inverse_fourier(z))): the first term is solved exactly, the second by the classical
/// Runge-Kutta method (integrating factor).
template <class Slope>
Eigen::VectorXcd exponential_steps(Eigen::VectorXcd z, const Eigen::VectorXcd& symbol, double step,
                                   int steps, Slope slope) {
  const Eigen::ArrayXcd half = (step / 2 * symbol.array()).exp();
  const auto change = [&](const Eigen::ArrayXcd& at) -> Eigen::ArrayXcd {
    return step * fourier(slope(inverse_fourier(at)).template cast<std::complex<double>>()).array();
  };
  for (int i = 0; i < steps; ++i) {
    const Eigen::ArrayXcd start = z.array(), a = change(start), b = change(half * (start + a / 2)),
                          c = change(half * start + b / 2), d = change(half * (half * start + c));
    z = half * (half * (start + a / 6) + (b + c) / 3) + d / 6;
  }
  return z;
}

/// Prints the errors for four numbers of coefficients, and the order of convergence: the slope of a line through their
/// logarithms, with its 95 % interval (Student's t for two degrees of freedom: 4.303).
inline void print_order(const char* name, const std::vector<int>& counts,
                        const std::vector<double>& errors) {
  const auto logarithms = [](const auto& numbers) {
    Eigen::VectorXd result(numbers.size());
    for (Eigen::Index i = 0; i < result.size(); ++i)
      result[i] = std::log(numbers[static_cast<std::size_t>(i)]);
    return Eigen::VectorXd(result.array() - result.mean());
  };
  const Eigen::VectorXd x = logarithms(counts), y = logarithms(errors);
  const double slope = x.dot(y) / x.squaredNorm();
  const double spread = std::sqrt((y - slope * x).squaredNorm() / 2 / x.squaredNorm());
  std::printf("%s:", name);
  for (const double error : errors) std::printf(" %.1e", error);
  std::printf(", order %.1f +- %.1f\n", -slope, 4.303 * spread);
}

}  // namespace galerkin
