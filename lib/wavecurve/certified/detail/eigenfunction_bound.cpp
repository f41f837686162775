#include "wavecurve/certified/detail/eigenfunction_bound.hpp"

#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

#include "wavecurve/certified/detail/ball_matrix.hpp"
#include "wavecurve/certified/rational.hpp"

namespace wavecurve::certified {

namespace {

/// Beyond that an eigenvalue problem in double precision takes longer than it may spare.
constexpr int most_coefficients = 160;

struct EigenPair {
  Ball value;
  std::vector<Ball> vector;
};

/// The eigenvalue of the largest modulus in double precision, if it is real, and its vector.
std::optional<EigenPair> approximate_pair(const SquareMatrix<Ball>& t) {
  const int n = t.size();
  Eigen::MatrixXd nearest(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) nearest(i, j) = t(i, j).to_double();
  }
  if (!nearest.allFinite()) return std::nullopt;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(nearest);
  if (solver.info() != Eigen::Success) return std::nullopt;
  Eigen::Index largest = 0;
  solver.eigenvalues().real().maxCoeff(&largest);
  if (solver.eigenvalues()[largest].imag() != 0) return std::nullopt;
  EigenPair pair{Ball::from_double(solver.eigenvalues()[largest].real()), {}};
  const Eigen::VectorXd vector = solver.eigenvectors().col(largest).real();
  for (const double value : vector) pair.vector.push_back(Ball::from_double(value));
  return pair;
}

std::size_t largest_place(const std::vector<Ball>& u) {
  std::size_t place = 0;
  for (std::size_t k = 1; k < u.size(); ++k) {
    if (std::abs(u[k].to_double()) > std::abs(u[place].to_double())) place = k;
  }
  return place;
}

/// A step of inverse iteration, which squares the error: x = (T - lambda)^-1 u is parallel to the
/// eigenvector but for that, and u / x to the distance of lambda from the eigenvalue. Nothing here is
/// proved. False if T - lambda is singular at the working precision.
bool improve(const SquareMatrix<Ball>& t, EigenPair& pair) {
  const int n = t.size();
  const long bits = WorkingPrecision::bits();
  BallMatrix shifted(t), right(n, 1), x(n, 1);
  for (int i = 0; i < n; ++i) {
    shifted.set(i, i, t(i, i) - pair.value);
    right.set(i, 0, pair.vector[static_cast<std::size_t>(i)]);
  }
  if (arb_mat_approx_solve(x.value, shifted.value, right.value, bits) == 0) return false;
  const auto place = static_cast<long>(largest_place(pair.vector));
  const Ball scale = x.get(place, 0).midpoint();
  if (scale.contains_zero() || !scale.is_finite()) return false;
  pair.value = (pair.value + pair.vector[static_cast<std::size_t>(place)] / scale).midpoint();
  for (int i = 0; i < n; ++i) {
    pair.vector[static_cast<std::size_t>(i)] = (x.get(i, 0) / scale).midpoint();
  }
  return true;
}

/// R of the residual.
Ball residual_bound(const SquareMatrix<Ball>& t, const EigenPair& pair) {
  Ball bound(0);
  for (int i = 0; i < t.size(); ++i) {
    Ball residual = -pair.value * pair.vector[static_cast<std::size_t>(i)];
    for (int j = 0; j < t.size(); ++j) {
      residual += t(i, j) * pair.vector[static_cast<std::size_t>(j)];
    }
    bound += Ball(i == 0 ? 1 : 2) * abs(residual);
  }
  return bound;
}

/// u as a polynomial in s, cos w = 2 s - 1, 0 <= s <= 1, by ascending powers: the Chebyshev polynomials
/// of cos w obey T_{k+1} = 2 cos w T_k - T_{k-1}.
std::vector<Ball> polynomial_of(const std::vector<Ball>& u) {
  std::vector<Ball> sum(u.size(), Ball(0)), before, current{Ball(1)};
  for (std::size_t k = 0; k < u.size(); ++k) {
    for (std::size_t i = 0; i < current.size(); ++i) {
      sum[i] += Ball(k == 0 ? 1 : 2) * u[k] * current[i];
    }
    std::vector<Ball> next(current.size() + 1, Ball(0));
    const Ball factor(k == 0 ? 1 : 2);
    for (std::size_t i = 0; i < current.size(); ++i) {
      next[i] -= factor * current[i];
      next[i + 1] += Ball(2) * factor * current[i];
    }
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = std::exchange(current, std::move(next));
  }
  return sum;
}

/// The coefficients in Bernstein's basis of the same degree on [0, 1].
std::vector<Ball> bernstein_of(const std::vector<Ball>& polynomial) {
  const auto degree = static_cast<unsigned long>(polynomial.size() - 1);
  std::vector<Ball> scaled;
  for (unsigned long j = 0; j <= degree; ++j) {
    scaled.push_back(polynomial[j] / Ball(Rational::binomial(degree, j)));
  }
  std::vector<Ball> result;
  for (unsigned long i = 0; i <= degree; ++i) {
    Ball sum(0);
    for (unsigned long j = 0; j <= i; ++j) sum += Ball(Rational::binomial(i, j)) * scaled[j];
    result.push_back(sum);
  }
  return result;
}

/// The two halves, by de Casteljau's algorithm.
std::pair<std::vector<Ball>, std::vector<Ball>> halves(std::vector<Ball> b) {
  const Ball half(Rational(1, 2));
  std::vector<Ball> left, right(b.size());
  for (std::size_t last = b.size(); last-- > 0;) {
    left.push_back(b.front());
    right[last] = b[last];
    for (std::size_t i = 0; i < last; ++i) b[i] = (b[i] + b[i + 1]) * half;
  }
  return {std::move(left), std::move(right)};
}

Ball least_of(const std::vector<Ball>& numbers) {
  Ball least = numbers.front();
  for (const Ball& number : numbers) {
    arb_min(least.get(), least.get(), number.get(), WorkingPrecision::bits());
  }
  return least;
}

}  // namespace

std::optional<Ball> positive_minimum(const std::vector<Ball>& u) {
  constexpr int most_pieces = 256;
  std::vector<std::vector<Ball>> open;
  {
    // The powers of s cancel by less than three bits a degree, (1 + sqrt 2)^2 < 6 times 2.
    const WorkingPrecision precision(WorkingPrecision::bits() + 4 * static_cast<long>(u.size()));
    open.push_back(bernstein_of(polynomial_of(u)));
  }
  std::optional<Ball> least;
  for (int pieces = 1; !open.empty(); ++pieces) {
    std::vector<Ball> piece = std::move(open.back());
    open.pop_back();
    if (pieces > most_pieces || !piece.front().is_positive() || !piece.back().is_positive()) {
      return std::nullopt;
    }
    const Ball bound = least_of(piece);
    if (bound.is_positive()) {
      least = least ? least_of({*least, bound}) : bound;
      continue;
    }
    auto [left, right] = halves(std::move(piece));
    open.push_back(std::move(left));
    open.push_back(std::move(right));
  }
  return least;
}

std::optional<Ball> spectral_radius_by_eigenfunction(const SquareMatrix<Ball>& t) {
  constexpr int most_steps = 8;
  if (t.size() > most_coefficients) return std::nullopt;
  auto pair = approximate_pair(t);
  if (!pair) return std::nullopt;
  // Until a step no longer gains.
  Ball residual = residual_bound(t, *pair);
  for (int step = 0; step < most_steps; ++step) {
    EigenPair next = *pair;
    if (!improve(t, next)) break;
    const Ball smaller = residual_bound(t, next);
    if (!certainly_less(smaller, residual)) break;
    *pair = std::move(next);
    residual = smaller;
  }
  if (!pair->vector.front().is_positive()) {
    for (Ball& value : pair->vector) value = -value;
  }
  const auto least = positive_minimum(pair->vector);
  if (!least) return std::nullopt;
  const Ball radius = residual / *least;
  return hull(pair->value - radius, pair->value + radius);
}

}  // namespace wavecurve::certified
