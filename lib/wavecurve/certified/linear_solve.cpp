#include "wavecurve/certified/linear_solve.hpp"

#include <stdexcept>
#include <string>

#include "wavecurve/certified/detail/ball_matrix.hpp"

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
