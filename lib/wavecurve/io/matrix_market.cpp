#include "wavecurve/io/matrix_market.hpp"

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>
#include <unsupported/Eigen/SparseExtra>

#include <fmt/format.h>

#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::io {

namespace {

namespace fs = std::filesystem;

bool is_symmetric(const Eigen::SparseMatrix<double>& matrix) {
  if (matrix.rows() != matrix.cols()) return false;
  const Eigen::SparseMatrix<double> transpose = matrix.transpose();
  return (matrix - transpose).norm() == 0;
}

}  // namespace

void write_matrix_market(const fs::path& path, const Eigen::SparseMatrix<double>& matrix) {
  const bool symmetric = is_symmetric(matrix);
  const Eigen::SparseMatrix<double> stored =
      symmetric ? Eigen::SparseMatrix<double>(matrix.triangularView<Eigen::Lower>()) : matrix;
  std::string text = fmt::format("%%MatrixMarket matrix coordinate  real {}\n{} {} {}\n",
                                 symmetric ? "symmetric" : "general", stored.rows(), stored.cols(),
                                 stored.nonZeros());
  for (int column = 0; column < stored.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(stored, column); entry; ++entry) {
      // The shortest decimals that are read back as the same number.
      text += fmt::format("{} {} {}\n", entry.row() + 1, entry.col() + 1, entry.value());
    }
  }
  write_file(path, text);
}

Eigen::SparseMatrix<double> read_matrix_market(const fs::path& path) {
  int symmetry = 0;
  bool is_complex = false, is_vector = false;
  Eigen::SparseMatrix<double> stored;
  if (!Eigen::getMarketHeader(path.string(), symmetry, is_complex, is_vector) ||
      !Eigen::loadMarket(stored, path.string())) {
    throw std::system_error(ENOENT, std::generic_category(), "cannot read " + path.string());
  }
  if (symmetry != Eigen::Symmetric) return stored;
  return stored.selfadjointView<Eigen::Lower>();
}

}  // namespace wavecurve::io
