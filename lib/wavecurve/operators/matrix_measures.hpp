#pragma once

#include <vector>

#include <Eigen/SparseCore>

namespace wavecurve {

/// max |a_ij - a_ji| / max |a_ij|; 0 for a zero matrix.
double symmetry_error(const Eigen::SparseMatrix<double>& matrix);

/// The share of the off-diagonal entries in the sum of the squares of all, or in the sum of the
/// magnitudes, 0 .. 1. Throws std::domain_error for a zero matrix.
double off_diagonal_energy(const Eigen::SparseMatrix<double>& matrix);
double off_diagonal_magnitude(const Eigen::SparseMatrix<double>& matrix);

/// The number of entries whose magnitude exceeds a fraction of the largest; with 1e-12 those that
/// are more than rounding.
Eigen::Index count_above(const Eigen::SparseMatrix<double>& matrix, double fraction);

/// For each row i: sum of |a_ij|, j other than i, over |a_ii| (of a symmetric matrix). Below 1 the
/// row is diagonally dominant. Infinite where the diagonal entry is zero.
Eigen::VectorXd off_diagonal_ratios(const Eigen::SparseMatrix<double>& matrix);

/// The matrix without the entries outside the given diagonal blocks; `borders` as in
/// matrix_picture: the first index of each block after the first.
Eigen::SparseMatrix<double> diagonal_blocks(const Eigen::SparseMatrix<double>& matrix,
                                            const std::vector<Eigen::Index>& borders);

}  // namespace wavecurve
