#include "wavecurve/io/matrix_market.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>
#include <unistd.h>
#include <unsupported/Eigen/SparseExtra>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::io {

namespace {

namespace fs = std::filesystem;

/// A file that vanishes with the object; saveMarket takes file names only.
class TemporaryFile {
 public:
  TemporaryFile() : path_((fs::temp_directory_path() / "wavecurve-matrix-XXXXXX").string()) {
    const int descriptor = ::mkstemp(path_.data());
    if (descriptor < 0) throw std::system_error(errno, std::generic_category(), path_);
    ::close(descriptor);
  }
  ~TemporaryFile() { ::unlink(path_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

bool is_symmetric(const Eigen::SparseMatrix<double>& matrix) {
  if (matrix.rows() != matrix.cols()) return false;
  const Eigen::SparseMatrix<double> transpose = matrix.transpose();
  return (matrix - transpose).norm() == 0;
}

}  // namespace

void write_matrix_market(const fs::path& path, const Eigen::SparseMatrix<double>& matrix) {
  // saveMarket marks a matrix as symmetric but writes all that it is given, and does not notice a
  // full disk: hence the triangle, and the count of lines.
  const bool symmetric = is_symmetric(matrix);
  const Eigen::SparseMatrix<double> stored =
      symmetric ? Eigen::SparseMatrix<double>(matrix.triangularView<Eigen::Lower>()) : matrix;
  const TemporaryFile temporary;
  const bool opened = Eigen::saveMarket(stored, temporary.path(), symmetric ? Eigen::Symmetric : 0);
  const std::string text = opened ? read_file(temporary.path()) : "";
  const auto lines = std::count(text.begin(), text.end(), '\n');
  if (lines != stored.nonZeros() + 2) {
    throw std::system_error(ENOSPC, std::generic_category(), "cannot write " + temporary.path());
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
