#include "wavecurve/certified/detail/elementary/polynomial_fit.hpp"

#include <algorithm>
#include <cmath>

#include "wavecurve/certified/detail/elementary/rounded_ball.hpp"

namespace wavecurve::certified {

namespace {

Ball value_at(const std::vector<Ball>& polynomial, const Ball& x) {
  Ball sum;
  for (std::size_t i = polynomial.size(); i-- > 0;) sum = sum * x + polynomial[i];
  return sum;
}

/// The coefficients of p(x + middle), by repeated division.
std::vector<Ball> expanded_at(std::vector<Ball> p, const Ball& middle) {
  for (std::size_t last = 0; last < p.size(); ++last) {
    for (std::size_t i = p.size() - 1; i-- > last;) p[i] += middle * p[i + 1];
  }
  return p;
}

}  // namespace

SeriesOnInterval series_on(const Ball& from, const Ball& to, int size, double ratio,
                           const std::function<Ball(int)>& term) {
  SeriesOnInterval series{{}, 0, from, to};
  for (int i = 0; i < size; ++i) series.terms.push_back(term(i));
  const double end = std::max(largest_magnitude(from), largest_magnitude(to));
  // Four roundings of doubles, against which it is raised by far more.
  series.rest = largest_magnitude(series.terms.back()) * std::pow(end, size - 1) * ratio /
                (1 - ratio) * (1 + 1e-12);
  return series;
}

std::vector<double> fit_polynomial(const SeriesOnInterval& series, int size) {
  const Ball middle = (series.from + series.to) / 2, radius = (series.to - series.from) / 2;
  std::vector<Ball> x, difference;
  for (int i = 0; i < size; ++i) {
    x.push_back(middle + radius * cos(Ball::pi() * (2 * i + 1) / (2 * size)));
    difference.push_back(value_at(series.terms, x.back()));
  }
  // Newton's divided differences, then his form multiplied out.
  const auto n = static_cast<std::size_t>(size);
  for (std::size_t order = 1; order < n; ++order) {
    for (std::size_t i = n - 1; i >= order; --i) {
      difference[i] = (difference[i] - difference[i - 1]) / (x[i] - x[i - order]);
    }
  }
  std::vector<Ball> polynomial(n);
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = n - 1; j > 0; --j)
      polynomial[j] = polynomial[j - 1] - x[i] * polynomial[j];
    polynomial[0] = difference[i] - x[i] * polynomial[0];
  }
  std::vector<double> rounded;
  for (const Ball& coefficient : polynomial) rounded.push_back(coefficient.to_double());
  return rounded;
}

double distance_on_interval(const SeriesOnInterval& series, const std::vector<double>& polynomial) {
  std::vector<Ball> difference = series.terms;
  for (std::size_t i = 0; i < polynomial.size(); ++i) {
    difference[i] -= Ball::from_double(polynomial[i]);
  }
  constexpr int pieces = 128;
  const Ball radius = (series.to - series.from) / (2 * pieces);
  double largest = 0;
  for (int i = 0; i < pieces; ++i) {
    const Ball middle = series.from + radius * (2 * i + 1);
    Ball sum, power = 1;
    for (const Ball& coefficient : expanded_at(difference, middle)) {
      sum += abs(coefficient) * power;
      power *= radius;
    }
    largest = std::max(largest, largest_magnitude(sum));
  }
  return (largest + series.rest) * (1 + 1e-12);
}

}  // namespace wavecurve::certified
