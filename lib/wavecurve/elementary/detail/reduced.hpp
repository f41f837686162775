#pragma once

#include <array>
#include <cstddef>

namespace wavecurve::elementary {

// The elementary functions on their reduced ranges, as the operations that are done, in their
// order. T is double, and this text is the specification of every result; or it is the number that
// certified/detail/elementary bounds the rounding errors with, and this text is what is proved.

/// A result before its last rounding: head + tail, of which the tail is the smaller.
template <class T>
struct Sum {
  T head, tail;
};

/// a + b + small for |a| >= |b|, and for a = 0. The rounding error of head = a + b is a double
/// itself (Dekker, 1971), and goes into the tail.
inline Sum<double> compensated_sum(double a, double b, double small) {
  const double head = a + b;
  return {head, (b - (head - a)) + small};
}

inline double half(double x) { return 0.5 * x; }

/// p_0 + x p_1 + x^2 p_2 + ...
template <class T, std::size_t N>
T polynomial(const std::array<double, N>& p, const T& x) {
  T sum = p[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = x * sum + p[i];
  return sum;
}

/// sin(r + low) = r + r^3 S(r^2) + low cos(r), |r| <= pi / 4 and a little more, |low| at most half
/// a unit of r; of the last cosine, 1 - r^2 / 2.
template <class T, std::size_t N>
Sum<T> reduced_sine(const std::array<double, N>& p, const T& r, const T& low) {
  const T square = r * r;
  return {r, (square * r) * polynomial(p, square) + low * (1.0 - half(square))};
}

/// cos(r + low) = 1 - r^2 / 2 + r^4 C(r^2) - low r.
template <class T, std::size_t N>
Sum<T> reduced_cosine(const std::array<double, N>& p, const T& r, const T& low) {
  const T square = r * r;
  return compensated_sum(T(1.0), -half(square),
                         (square * square) * polynomial(p, square) - r * low);
}

/// exp(r + low) = 1 + r + low + r^2 E(r), |r| <= log(2) / 2 and a little more.
template <class T, std::size_t N>
Sum<T> reduced_exponential(const std::array<double, N>& p, const T& r, const T& low) {
  return compensated_sum(T(1.0), r, (r * r) * polynomial(p, r) + low);
}

/// The same less 1, and low = 0.
template <class T, std::size_t N>
Sum<T> reduced_exponential_minus_one(const std::array<double, N>& p, const T& r) {
  return {r, (r * r) * polynomial(p, r)};
}

/// log(1 + f) + high + low, 11/16 <= 1 + f < 11/8, |high| > 1/2 or 0. With s = f / (2 + f),
///   log(1 + f) = 2 artanh(s) = f - f^2 / 2 + s (f^2 / 2 + s^2 L(s^2)).
template <class T, std::size_t N>
Sum<T> reduced_logarithm(const std::array<double, N>& p, const T& f, const T& high, const T& low) {
  const T s = f / (f + 2.0), square = s * s, half_square = half(f * f);
  return compensated_sum(high, f,
                         (s * (half_square + square * polynomial(p, square)) + low) - half_square);
}

/// The tail of arctan(q + low) with the head q, 0 <= q <= 27/64: q^3 A(q^2) + low / (1 + q^2).
template <class T, std::size_t N>
T small_arctangent_tail(const std::array<double, N>& p, const T& q, const T& low) {
  const T square = q * q;
  return (square * q) * polynomial(p, square) + low / (square + 1.0);
}

/// The tail of arctan(q + low) with the head arctan(c) rounded to a double, |q - c| <= 1/64, rest =
/// arctan(c) - head: arctan(q) = arctan(c) + arctan(u), u = (q - c) / (1 + c q).
template <class T, std::size_t N>
T arctangent_tail(const std::array<double, N>& p, double c, double rest, const T& q, const T& low) {
  const T u = (q - c) / (q * c + 1.0), square = u * u;
  return ((square * u) * polynomial(p, square) + low / (q * q + 1.0) + rest) + u;
}

}  // namespace wavecurve::elementary
