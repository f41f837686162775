#include "wavecurve/certified/detail/verified_inverse.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/LU>

namespace wavecurve::certified {

namespace {

/// The unit roundoff.
constexpr double unit = std::numeric_limits<double>::epsilon() / 2;

/// An upper bound of n u / (1 - n u), by which a sum of n products is off, whatever the order,
/// relative to the sum of their magnitudes (Higham, "Accuracy and stability", section 3.1). 1.01
/// covers n < 10^12 and the rounding of bounds of a few operations.
double rounding_of_sum(Eigen::Index n) { return 1.01 * static_cast<double>(n) * unit; }

/// Larger than a sum of n numbers >= 0 by its roundings, and than what underflow takes from
/// products.
double rounded_up(double sum, Eigen::Index n) {
  return sum * (1 + 2 * rounding_of_sum(n + 2)) + std::numeric_limits<double>::min();
}

/// Numbers as doubles times a common power of two, so that those of thousands of bits fit.
struct Scaled {
  Eigen::VectorXd numbers;
  long exponent = 0;
};

Scaled scaled_midpoints(const std::vector<Ball>& x) {
  Scaled result{Eigen::VectorXd(static_cast<Eigen::Index>(x.size())), 0};
  mag_t largest, one;
  mag_init(largest);
  mag_init(one);
  for (const Ball& ball : x) {
    arf_get_mag(one, arb_midref(ball.get()));
    mag_max(largest, largest, one);
  }
  result.exponent = mag_is_special(largest) ? 0 : MAG_EXP(largest);
  mag_clear(largest);
  mag_clear(one);
  arf_t scaled;
  arf_init(scaled);
  for (std::size_t i = 0; i < x.size(); ++i) {
    arf_mul_2exp_si(scaled, arb_midref(x[i].get()), -result.exponent);
    result.numbers[static_cast<Eigen::Index>(i)] = arf_get_d(scaled, ARF_RND_NEAR);
  }
  arf_clear(scaled);
  return result;
}

/// Upper bounds of the magnitudes of enclosures.
Scaled scaled_bounds(const std::vector<Ball>& x) {
  Scaled result{Eigen::VectorXd(static_cast<Eigen::Index>(x.size())), 0};
  mag_t largest, one;
  mag_init(largest);
  mag_init(one);
  for (const Ball& ball : x) {
    arb_get_mag(one, ball.get());
    mag_max(largest, largest, one);
  }
  result.exponent = mag_is_special(largest) ? 0 : MAG_EXP(largest);
  for (std::size_t i = 0; i < x.size(); ++i) {
    arb_get_mag(one, x[i].get());
    mag_mul_2exp_si(one, one, -result.exponent);
    // 30 bits fit a double; what is far below the largest may underflow.
    result.numbers[static_cast<Eigen::Index>(i)] =
        mag_get_d(one) + std::numeric_limits<double>::min();
  }
  mag_clear(largest);
  mag_clear(one);
  return result;
}

Ball times_power_of_two(double x, long exponent) {
  Ball result = Ball::from_double(x);
  arb_mul_2exp_si(result.get(), result.get(), exponent);
  return result;
}

double largest_log2(const std::vector<Ball>& x, bool radius) {
  double largest = -HUGE_VAL;
  for (const Ball& ball : x) {
    const Ball part = radius ? ball.radius() : ball.midpoint();
    mag_t bound;
    mag_init(bound);
    arb_get_mag(bound, part.get());
    if (!mag_is_special(bound)) largest = std::max(largest, double(MAG_EXP(bound)));
    mag_clear(bound);
  }
  return largest;
}

}  // namespace

std::optional<VerifiedInverse> VerifiedInverse::of(const Eigen::MatrixXd& matrix,
                                                   double row_error) {
  const Eigen::Index n = matrix.rows();
  Eigen::MatrixXd inverse = matrix.partialPivLu().inverse();
  if (!inverse.allFinite()) return std::nullopt;
  double delta = 0;
  {
    Eigen::MatrixXd rest = -(inverse * matrix);
    rest.diagonal().array() += 1;
    const Eigen::VectorXd found = rest.cwiseAbs().rowwise().sum();
    const Eigen::VectorXd rows = matrix.cwiseAbs().rowwise().sum();
    const Eigen::VectorXd products = inverse.cwiseAbs() * rows;  // row sums of |R| |B'|
    const Eigen::VectorXd norms = inverse.cwiseAbs().rowwise().sum();
    for (Eigen::Index i = 0; i < n; ++i) {
      const double rounding = rounding_of_sum(n + 2) * (rounded_up(products[i], 2 * n) + 1);
      delta = std::max(delta, rounded_up(found[i], n) + rounding +
                                  rounded_up(norms[i], n) * row_error * (1 + 4 * unit));
    }
  }
  delta *= 1 + 8 * unit;
  if (!(delta < 1)) return std::nullopt;
  return VerifiedInverse(std::move(inverse), delta);
}

std::vector<Ball> VerifiedInverse::within_bounds(std::vector<Ball> x,
                                                 const std::vector<Ball>& residual) const {
  const Scaled bounds = scaled_bounds(residual);
  const Eigen::VectorXd product = inverse_.cwiseAbs() * bounds.numbers;
  const Eigen::Index n = product.size();
  const double norm = rounded_up(product.maxCoeff(), n);
  const double common = delta_ / (1 - delta_) * norm * (1 + 8 * unit);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double radius = (rounded_up(product[i], n) + common) * (1 + 2 * unit);
    const Ball error = times_power_of_two(radius, bounds.exponent);
    Ball& ball = x[static_cast<std::size_t>(i)];
    arb_add_error(ball.get(), error.get());
  }
  return x;
}

std::vector<Ball> VerifiedInverse::solve(
    const std::function<std::vector<Ball>(const std::vector<Ball>&)>& residual) const {
  std::vector<Ball> x(static_cast<std::size_t>(inverse_.rows()), Ball(0));
  std::vector<Ball> r = residual(x);
  double reached = HUGE_VAL;
  // Each step leaves delta of the residual, until it is of the size of its own radius.
  for (;;) {
    const double size = largest_log2(r, false);
    if (size >= reached || size <= largest_log2(r, true)) break;
    reached = size;
    const Scaled middle = scaled_midpoints(r);
    const Eigen::VectorXd step = inverse_ * middle.numbers;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += times_power_of_two(step[static_cast<Eigen::Index>(i)], middle.exponent);
      x[i] = x[i].midpoint();
    }
    r = residual(x);
  }
  return within_bounds(std::move(x), r);
}

}  // namespace wavecurve::certified
