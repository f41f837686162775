#include "wavecurve/operators/circulant.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/transform/plain_transform.hpp"

namespace wavecurve {

Eigen::VectorXd circulant_column(const Filter<double>& mu, Eigen::Index samples, int d) {
  const double scale = std::ldexp(1.0, checked_log2(samples) * d);
  Eigen::VectorXd column = scale * plain::periodized(mu, samples);
  // The sums at r and -r have the same terms in another order; one of them is taken for both.
  const double sign = d % 2 == 0 ? 1 : -1;
  if (d % 2 != 0) column[0] = column[samples / 2] = 0;
  for (Eigen::Index r = 1; r < samples - r; ++r) column[samples - r] = sign * column[r];
  return column;
}

Eigen::VectorXd circulant_eigenvalues(const Filter<double>& mu, Eigen::Index samples, int d) {
  const double scale = std::ldexp(1.0, checked_log2(samples) * d);
  if (d % 2 != 0) {
    throw std::invalid_argument(must_be("d", d, "even for a symmetric circulant"));
  }
  const double step = std::numbers::pi / static_cast<double>(samples);
  // The angles are multiples of pi / samples, of which the sine has the period samples but for its
  // sign.
  Eigen::ArrayXd sines =
                     step * Eigen::ArrayXd::LinSpaced(samples, 0, static_cast<double>(samples - 1)),
                 cosines(samples);
  sine_cosine(sines, sines, cosines);
  Eigen::VectorXd eigenvalues(samples);
  for (Eigen::Index k = 0; k < samples; ++k) {
    // cos(2 t) = 1 - 2 sin(t)^2: for d > 0 the ones sum to zero, and what is left does not cancel.
    double sum = 0;
    for (int l = mu.first_index; l <= mu.last_index(); ++l) {
      const double sine = sines[k * std::abs(l) % samples];
      sum += mu[l] * (d == 0 ? 1 - 2 * sine * sine : -2 * sine * sine);
    }
    eigenvalues[k] = scale * sum;
  }
  return eigenvalues;
}

Eigen::VectorXd circulant_symbol(const Filter<double>& mu, Eigen::Index samples, int d) {
  const double scale = std::ldexp(1.0, checked_log2(samples) * d);
  if (d % 2 != 0) {
    throw std::invalid_argument(must_be("d", d, "even for a symmetric circulant"));
  }
  const double step = std::numbers::pi / static_cast<double>(samples);
  std::vector<double> weights;  // of sin(l t)^2, l = 1, 2, ...
  double sum = mu[0];
  for (int l = 1; l <= mu.last_index(); ++l) {
    weights.push_back(-4 * scale * mu[l]);
    sum += 2 * mu[l];
  }
  // Each angle is the sum of two of a table, in the first quadrant: their sine does not cancel.
  constexpr std::size_t block = 64;
  std::array<double, block> sines, cosines;
  for (std::size_t i = 0; i < std::min<std::size_t>(block, samples / 2 + 1); ++i) {
    const SineCosine small = sine_cosine(step * static_cast<double>(i));
    sines[i] = small.sine;
    cosines[i] = small.cosine;
  }
  SineCosine large = {0, 1};
  Eigen::VectorXd symbol(samples / 2 + 1);
  for (Eigen::Index k = 0; k < symbol.size(); ++k) {
    const std::size_t i = static_cast<std::size_t>(k) % block;
    if (i == 0) {
      large = sine_cosine(step * static_cast<double>(k));
    }
    const double sine = large.sine * cosines[i] + large.cosine * sines[i];
    const double cosine = large.cosine * cosines[i] - large.sine * sines[i];
    double value = d == 0 ? sum : 0, s = sine, c = cosine;
    for (const double weight : weights) {
      value += weight * s * s;
      // The sum of two angles: for small ones all terms are positive, and s is exact relative to s.
      const double next = s * cosine + c * sine;
      c = c * cosine - s * sine;
      s = next;
    }
    symbol[k] = value;
  }
  return symbol;
}

}  // namespace wavecurve
