#include "wavecurve/operators/matrix_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace wavecurve {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

template <class Visit>
void for_each_entry(const Matrix& matrix, Visit visit) {
  for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
    for (Matrix::InnerIterator entry(matrix, j); entry; ++entry) {
      visit(entry.row(), entry.col(), entry.value());
    }
  }
}

template <class Weight>
double off_diagonal_share(const Matrix& matrix, Weight weight) {
  double diagonal = 0, off_diagonal = 0;
  for_each_entry(matrix, [&](Eigen::Index i, Eigen::Index j, double value) {
    (i == j ? diagonal : off_diagonal) += weight(value);
  });
  if (diagonal + off_diagonal == 0) throw std::domain_error("a zero matrix has no energy to share");
  return off_diagonal / (diagonal + off_diagonal);
}

double largest_magnitude(const Matrix& matrix) {
  double largest = 0;
  for_each_entry(matrix, [&](Eigen::Index, Eigen::Index, double value) {
    largest = std::max(largest, std::abs(value));
  });
  return largest;
}

}  // namespace

double symmetry_error(const Matrix& matrix) {
  const double largest = largest_magnitude(matrix);
  const Matrix transpose = matrix.transpose();
  return largest == 0 ? 0 : largest_magnitude(matrix - transpose) / largest;
}

double off_diagonal_energy(const Matrix& matrix) {
  return off_diagonal_share(matrix, [](double value) { return value * value; });
}

double off_diagonal_magnitude(const Matrix& matrix) {
  return off_diagonal_share(matrix, [](double value) { return std::abs(value); });
}

Eigen::Index count_above(const Matrix& matrix, double fraction) {
  const double threshold = fraction * largest_magnitude(matrix);
  Eigen::Index count = 0;
  for_each_entry(matrix, [&](Eigen::Index, Eigen::Index, double value) {
    count += std::abs(value) > threshold ? 1 : 0;
  });
  return count;
}

Eigen::VectorXd off_diagonal_ratios(const Matrix& matrix) {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(matrix.rows());
  for_each_entry(matrix, [&](Eigen::Index i, Eigen::Index j, double value) {
    if (i != j) sums[i] += std::abs(value);
  });
  for (Eigen::Index i = 0; i < sums.size(); ++i) {
    const double diagonal = std::abs(matrix.coeff(i, i));
    sums[i] = diagonal == 0 ? std::numeric_limits<double>::infinity() : sums[i] / diagonal;
  }
  return sums;
}

Matrix diagonal_blocks(const Matrix& matrix, const std::vector<Eigen::Index>& borders) {
  const auto block = [&](Eigen::Index index) {
    return std::upper_bound(borders.begin(), borders.end(), index) - borders.begin();
  };
  Matrix result = matrix;
  result.prune([&](Eigen::Index i, Eigen::Index j, double) { return block(i) == block(j); });
  return result;
}

}  // namespace wavecurve
