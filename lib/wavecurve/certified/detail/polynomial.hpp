#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "wavecurve/certified/rational.hpp"

namespace wavecurve::certified {

/// Coefficients by ascending power. Scalar is Ball or Rational.
template <class Scalar>
using Polynomial = std::vector<Scalar>;

template <class Scalar>
Polynomial<Scalar> operator*(const Polynomial<Scalar>& a, const Polynomial<Scalar>& b) {
  if (a.empty() || b.empty()) return {};
  Polynomial<Scalar> product(a.size() + b.size() - 1, Scalar(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  }
  return product;
}

template <class Scalar>
Polynomial<Scalar> power(const Polynomial<Scalar>& base, int exponent) {
  Polynomial<Scalar> result{Scalar(1)};
  for (int i = 0; i < exponent; ++i) result = result * base;
  return result;
}

/// p((1 - (x + 1/x) / 2) / 2) times x^degree: the trigonometric polynomial p(sin^2(w/2)), x =
/// e^{-iw}, with indices from -degree to degree.
template <class Scalar>
Polynomial<Scalar> in_sine_squared(const Polynomial<Scalar>& p) {
  const Scalar half = Scalar(1) / Scalar(2), quarter = Scalar(1) / Scalar(4);
  const Polynomial<Scalar> sine_squared{-quarter, half, -quarter};
  const std::size_t degree = p.size() - 1;
  Polynomial<Scalar> result(2 * degree + 1, Scalar(0));
  Polynomial<Scalar> factor{Scalar(1)};
  for (std::size_t k = 0; k <= degree; ++k) {
    for (std::size_t i = 0; i < factor.size(); ++i) result[degree - k + i] += p[k] * factor[i];
    factor = factor * sine_squared;
  }
  return result;
}

/// P_N(y) = sum_{k<N} binomial(N-1+k, k) y^k, the solution of lowest degree of
/// (1-y)^N P_N(y) + y^N P_N(1-y) = 1 (Daubechies, Ten Lectures, section 6.1).
inline Polynomial<Rational> halfband_polynomial(int order) {
  Polynomial<Rational> p;
  for (int k = 0; k < order; ++k) {
    p.push_back(Rational::binomial(static_cast<unsigned long>(order - 1 + k),
                                   static_cast<unsigned long>(k)));
  }
  return p;
}

/// ((1 + x) / 2)^order.
template <class Scalar>
Polynomial<Scalar> averaging_polynomial(int order) {
  const Scalar half = Scalar(1) / Scalar(2);
  return power(Polynomial<Scalar>{half, half}, order);
}

}  // namespace wavecurve::certified
