#pragma once

#include <filesystem>

#include <Eigen/SparseCore>

namespace wavecurve::io {

/// Writes a MatrixMarket coordinate file (Eigen's saveMarket), 18 significant digits, so that
/// reading gives the same doubles. A matrix that equals its transpose is stored as "symmetric",
/// that is by its lower triangle. All or nothing, as write_file; throws std::system_error naming
/// the path.
void write_matrix_market(const std::filesystem::path& path,
                         const Eigen::SparseMatrix<double>& matrix);

/// Reads such a file. Throws std::system_error if it cannot be opened.
Eigen::SparseMatrix<double> read_matrix_market(const std::filesystem::path& path);

}  // namespace wavecurve::io
