#include "wavecurve/certified/linear_solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "wavecurve/certified/detail/ball_matrix.hpp"
#include "wavecurve/certified/detail/verified_inverse.hpp"

namespace wavecurve::certified {

namespace {

class RationalMatrix {
 public:
  RationalMatrix(long rows, long columns) { fmpq_mat_init(value, rows, columns); }
  RationalMatrix(const RationalMatrix&) = delete;
  RationalMatrix& operator=(const RationalMatrix&) = delete;
  ~RationalMatrix() { fmpq_mat_clear(value); }
  fmpq_mat_t value;
};

/// Below so many equations an elimination on enclosures is the faster way.
constexpr int few = 24;

/// The system with each row divided by the power of two that its largest entry lies at, and that as a
/// matrix of doubles with a bound of the row sums of the differences.
struct ScaledSystem {
  BallMatrix matrix, right;
  Eigen::MatrixXd nearest;
  double row_error = 0;

  ScaledSystem(const SquareMatrix<Ball>& a, const std::vector<Ball>& b)
      : matrix(a), right(a.size(), 1), nearest(a.size(), a.size()) {
    for (int i = 0; i < a.size(); ++i) {
      right.set(i, 0, b[static_cast<std::size_t>(i)]);
      const long exponent = largest_exponent(i);
      arb_mul_2exp_si(arb_mat_entry(right.value, i, 0), arb_mat_entry(right.value, i, 0),
                      -exponent);
      double error = 0;
      for (int j = 0; j < a.size(); ++j) {
        arb_ptr entry = arb_mat_entry(matrix.value, i, j);
        arb_mul_2exp_si(entry, entry, -exponent);
        nearest(i, j) = arf_get_d(arb_midref(entry), ARF_RND_NEAR);
        // Half a unit in the last place, what underflows, and the radius; the sum is rounded, too.
        error += std::abs(nearest(i, j)) * std::numeric_limits<double>::epsilon() +
                 std::numeric_limits<double>::min() + mag_get_d(arb_radref(entry));
      }
      row_error = std::max(row_error, 1.01 * error);
    }
  }

 private:
  long largest_exponent(int row) const {
    mag_t largest, one;
    mag_init(largest);
    mag_init(one);
    for (long j = 0; j < arb_mat_ncols(matrix.value); ++j) {
      arf_get_mag(one, arb_midref(arb_mat_entry(matrix.value, row, j)));
      mag_max(largest, largest, one);
    }
    const long exponent = mag_is_special(largest) ? 0 : MAG_EXP(largest);
    mag_clear(largest);
    mag_clear(one);
    return exponent;
  }
};

/// By an approximate inverse in double precision, where that proves the matrix regular and is sure to
/// gain ten bits a step. Near delta = 1 a step may gain less than one, and solve() ends then, whatever
/// the precision: an elimination at a higher one would not.
std::optional<std::vector<Ball>> solve_by_inverse(const SquareMatrix<Ball>& a,
                                                  const std::vector<Ball>& b) {
  const ScaledSystem system(a, b);
  const auto inverse = VerifiedInverse::of(system.nearest, system.row_error);
  constexpr double small_part = 1.0 / 1024;
  if (!inverse || !(inverse->delta() < small_part)) return std::nullopt;
  const int n = a.size();
  return inverse->solve([&](const std::vector<Ball>& x) {
    BallMatrix at(n, 1);
    for (int i = 0; i < n; ++i) at.set(i, 0, x[static_cast<std::size_t>(i)]);
    std::vector<Ball> residual(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
      arb_dot(residual[static_cast<std::size_t>(i)].get(), arb_mat_entry(system.right.value, i, 0),
              1, arb_mat_entry(system.matrix.value, i, 0), 1, arb_mat_entry(at.value, 0, 0), 1, n,
              WorkingPrecision::bits());
    }
    return residual;
  });
}

void require_length(int size, std::size_t length) {
  if (static_cast<std::size_t>(size) == length) return;
  throw std::invalid_argument("a linear system of " + std::to_string(size) +
                              " equations has a right-hand side of " + std::to_string(length) +
                              " numbers: must be as many");
}

}  // namespace

std::optional<std::vector<Ball>> solve(const SquareMatrix<Ball>& a, const std::vector<Ball>& b) {
  const int n = a.size();
  require_length(n, b.size());
  if (n > few) {
    if (auto x = solve_by_inverse(a, b)) return x;
  }
  const BallMatrix matrix(a);
  BallMatrix right(n, 1), solution(n, 1);
  for (int i = 0; i < n; ++i) right.set(i, 0, b[static_cast<std::size_t>(i)]);
  if (!arb_mat_solve(solution.value, matrix.value, right.value, WorkingPrecision::bits())) {
    return std::nullopt;
  }
  std::vector<Ball> x;
  for (int i = 0; i < n; ++i) x.push_back(solution.get(i, 0));
  return x;
}

std::optional<std::vector<Rational>> solve(const SquareMatrix<Rational>& a,
                                           const std::vector<Rational>& b) {
  const int n = a.size();
  require_length(n, b.size());
  RationalMatrix matrix(n, n), right(n, 1), solution(n, 1);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) fmpq_set(fmpq_mat_entry(matrix.value, i, j), a(i, j).get());
    fmpq_set(fmpq_mat_entry(right.value, i, 0), b[static_cast<std::size_t>(i)].get());
  }
  if (!fmpq_mat_solve(solution.value, matrix.value, right.value)) return std::nullopt;
  std::vector<Rational> x(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    fmpq_set(x[static_cast<std::size_t>(i)].get(), fmpq_mat_entry(solution.value, i, 0));
  }
  return x;
}

}  // namespace wavecurve::certified
