#pragma once

#include <functional>
#include <vector>

#include "wavecurve/certified/ball.hpp"

namespace wavecurve::certified {

/// A power series sum_i t_i x^i on an interval: its first terms, and a bound of what the others add.
struct SeriesOnInterval {
  std::vector<Ball> terms;
  double rest = 0;
  Ball from, to;
};

/// The first terms of a series with |t_{i+1} x| <= ratio |t_i x|, ratio < 1, on the interval for
/// all i from size - 1 on: the rest is below |last term| ratio / (1 - ratio).
SeriesOnInterval series_on(const Ball& from, const Ball& to, int size, double ratio,
                           const std::function<Ball(int)>& term);

/// A polynomial of so many coefficients, rounded to doubles, that interpolates the series at the
/// interval's Chebyshev points: of all polynomials nearly the nearest.
std::vector<double> fit_polynomial(const SeriesOnInterval& series, int size);

/// An upper bound of |series - polynomial| on the whole interval: the difference is a polynomial
/// itself, and is expanded at the middle of each of 128 pieces.
double distance_on_interval(const SeriesOnInterval& series, const std::vector<double>& polynomial);

}  // namespace wavecurve::certified
