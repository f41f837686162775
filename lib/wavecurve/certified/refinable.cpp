#include "wavecurve/certified/refinable.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include "wavecurve/certified/detail/two_scale_moments.hpp"
#include "wavecurve/certified/linear_solve.hpp"
#include "wavecurve/filters/two_scale_matrix.hpp"

namespace wavecurve::certified {

namespace {

/// The null vector of (R) with the scale of (S): the last equation is replaced, and checked
/// afterwards.
template <class Scalar>
std::vector<Scalar> solve_for_moment(SquareMatrix<Scalar> system,
                                     const std::vector<Scalar>& weights, int d) {
  const int last = system.size() - 1;
  std::vector<Scalar> replaced, right(weights.size(), Scalar(0));
  for (int j = 0; j <= last; ++j) {
    replaced.push_back(system(last, j));
    system(last, j) = weights[static_cast<std::size_t>(j)];
  }
  right.back() = moment<Scalar>(d);
  const auto solution = solve(system, right);
  Scalar residual(0);
  for (std::size_t j = 0; solution && j < replaced.size(); ++j)
    residual += replaced[j] * (*solution)[j];
  if (!solution || !residual.contains_zero()) {
    throw std::domain_error("the two-scale system for the derivative of order " +
                            std::to_string(d) + " could not be proved to have rank deficiency one");
  }
  return *solution;
}

}  // namespace

template <class Scalar>
Filter<Scalar> derivative_at_integers(const Filter<Scalar>& mask, int d) {
  const int first = mask.first_index + 1, last = mask.last_index() - 1;  // zero at the end points
  const int n = last - first + 1;
  if (n < 1) {
    throw std::domain_error("a refinable function with " + std::to_string(mask.size()) +
                            " mask coefficients has no inner integer and is not continuous");
  }
  const Scalar scale = integer_power<Scalar>(2, d);
  SquareMatrix<Scalar> system(n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      system(i, j) = scale * mask[2 * (first + i) - (first + j)] - Scalar(i == j ? 1 : 0);
    }
  }
  std::vector<Scalar> weights;
  for (int j = 0; j < n; ++j) weights.push_back(integer_power<Scalar>(first + j, d));
  return {first, solve_for_moment(system, weights, d)};
}

template <class Scalar>
Filter<Scalar> autocorrelation_derivative_at_integers(const Filter<Scalar>& alpha, int d) {
  const int last = alpha.last_index() - 1, first = first_two_scale_unknown(d);
  if (last < first) {
    throw std::domain_error("the support is too short for a derivative of order " +
                            std::to_string(d));
  }
  const auto weights = moment_weights<Scalar>(last, d);
  return mirrored(solve_for_moment(two_scale_matrix(alpha, d), weights, d), last, d);
}

template Filter<Ball> derivative_at_integers(const Filter<Ball>&, int);
template Filter<Rational> derivative_at_integers(const Filter<Rational>&, int);
template Filter<Ball> autocorrelation_derivative_at_integers(const Filter<Ball>&, int);
template Filter<Rational> autocorrelation_derivative_at_integers(const Filter<Rational>&, int);

}  // namespace wavecurve::certified
