#include "wavecurve/operators/matrix_measures.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve {
namespace {

Eigen::SparseMatrix<double> sparse(const Eigen::Matrix3d& dense) { return dense.sparseView(); }

Eigen::Matrix3d example() {
  Eigen::Matrix3d matrix;
  matrix << 4, -2, 1, -2, 3, 0, 1, 0, 0;
  return matrix;
}

TEST(MatrixMeasures, ByHand) {
  const auto matrix = sparse(example());
  EXPECT_DOUBLE_EQ(off_diagonal_energy(matrix), 10.0 / 35);
  EXPECT_DOUBLE_EQ(off_diagonal_magnitude(matrix), 6.0 / 13);
  const Eigen::VectorXd ratios = off_diagonal_ratios(matrix);
  EXPECT_DOUBLE_EQ(ratios[0], 3.0 / 4);
  EXPECT_DOUBLE_EQ(ratios[1], 2.0 / 3);
  EXPECT_TRUE(std::isinf(ratios[2]));
  EXPECT_EQ(symmetry_error(matrix), 0);
  EXPECT_EQ(count_above(matrix, 0), 6);
  EXPECT_EQ(count_above(matrix, 0.5), 2);  // 4 and 3; twice -2 is not above
  Eigen::Matrix3d skewed = example();
  skewed(2, 0) = -1;
  EXPECT_DOUBLE_EQ(symmetry_error(sparse(skewed)), 2.0 / 4);
}

TEST(MatrixMeasures, DiagonalBlocksDropTheRest) {
  Eigen::Matrix3d expected = example();
  expected(0, 1) = expected(1, 0) = expected(0, 2) = expected(2, 0) = 0;
  EXPECT_EQ(diagonal_blocks(sparse(example()), {1}).toDense(), expected);
}

TEST(MatrixMeasures, AZeroMatrixHasNoEnergy) {
  EXPECT_THROW(off_diagonal_energy(Eigen::SparseMatrix<double>(2, 2)), std::domain_error);
  EXPECT_EQ(symmetry_error(Eigen::SparseMatrix<double>(2, 2)), 0);
}

}  // namespace
}  // namespace wavecurve
