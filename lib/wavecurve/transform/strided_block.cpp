#include "wavecurve/transform/strided_block.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve {

void StridedBlock::append_pattern(Eigen::Index row, double value) {
  if (value == 0) return;
  row_.push_back(static_cast<int>(row));
  value_.push_back(value);
}

void StridedBlock::end_pattern() { begin_.push_back(row_.size()); }

StridedBlock StridedBlock::with_fine_rows(const Generator& generator, Eigen::Index coarse) {
  StridedBlock block;
  block.rows_ = generator.size();
  block.cols_ = coarse;
  block.step_ = generator.size() / coarse;
  for (Eigen::Index n = 0; n < generator.size(); ++n) block.append_pattern(n, generator[n]);
  block.end_pattern();
  return block;
}

StridedBlock StridedBlock::with_fine_columns(const Generator& generator, Eigen::Index coarse) {
  StridedBlock block;
  block.rows_ = coarse;
  block.cols_ = generator.size();
  block.period_ = generator.size() / coarse;
  // Fine n = r + stride s meets coarse k in generator_{r + stride (s - k)}: row k - s of the
  // pattern.
  for (Eigen::Index r = 0; r < block.period_; ++r) {
    for (Eigen::Index row = 0; row < coarse; ++row) {
      block.append_pattern(row, generator[r + block.period_ * ((coarse - row) % coarse)]);
    }
    block.end_pattern();
  }
  return block;
}

Eigen::Index StridedBlock::non_zeros() const {
  return cols_ / period_ * static_cast<Eigen::Index>(row_.size());
}

void StridedBlock::append_column(Eigen::Index column, int row_offset, int*& row,
                                 double*& value) const {
  const std::size_t pattern = static_cast<std::size_t>(column % period_);
  const int shift = static_cast<int>(column / period_ * step_);
  const auto begin = row_.begin() + static_cast<std::ptrdiff_t>(begin_[pattern]);
  const auto end = row_.begin() + static_cast<std::ptrdiff_t>(begin_[pattern + 1]);
  const auto wraps = std::lower_bound(begin, end, static_cast<int>(rows_) - shift);
  const auto append = [&](auto first, auto last, int down) {
    value = std::copy(value_.begin() + (first - row_.begin()),
                      value_.begin() + (last - row_.begin()), value);
    row = std::transform(first, last, row, [down](int r) { return r + down; });
  };
  append(wraps, end, row_offset + shift - static_cast<int>(rows_));
  append(begin, wraps, row_offset + shift);
}

void check_non_zeros(Eigen::Index count) {
  if (count > std::numeric_limits<int>::max()) {
    throw std::invalid_argument(fmt::format(
        "the matrix has {} non-zeros or more, but at most {} can be stored; apply it without "
        "assembling it",
        count, std::numeric_limits<int>::max()));
  }
}

Eigen::SparseMatrix<double> assemble(const std::vector<std::vector<StridedBlock>>& blocks) {
  Eigen::Index rows = 0, cols = 0, total = 0;
  for (const StridedBlock& block : blocks.front()) rows += block.rows();
  for (const auto& column_of_blocks : blocks) {
    for (const StridedBlock& block : column_of_blocks) total += block.non_zeros();
    cols += column_of_blocks.front().cols();
  }
  check_non_zeros(total);
  Eigen::SparseMatrix<double> result(rows, cols);
  result.resizeNonZeros(total);
  int* row = result.innerIndexPtr();
  double* value = result.valuePtr();
  int* column_begin = result.outerIndexPtr();
  for (const auto& column_of_blocks : blocks) {
    for (Eigen::Index k = 0; k < column_of_blocks.front().cols(); ++k) {
      int row_offset = 0;
      for (const StridedBlock& block : column_of_blocks) {
        block.append_column(k, row_offset, row, value);
        row_offset += static_cast<int>(block.rows());
      }
      *++column_begin = static_cast<int>(row - result.innerIndexPtr());
    }
  }
  return result;
}

}  // namespace wavecurve
