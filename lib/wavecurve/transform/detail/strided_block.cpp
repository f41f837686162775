#include "wavecurve/transform/detail/strided_block.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve {

void StridedBlock::reserve(const Generator& generator) {
  const auto count = static_cast<std::size_t>((generator.array() != 0).count());
  row_.reserve(count);
  value_.reserve(count);
}

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
  block.reserve(generator);
  for (Eigen::Index n = 0; n < generator.size(); ++n) block.append_pattern(n, generator[n]);
  block.end_pattern();
  return block;
}

StridedBlock StridedBlock::with_fine_columns(const Generator& generator, Eigen::Index coarse) {
  StridedBlock block;
  block.rows_ = coarse;
  block.cols_ = generator.size();
  block.period_ = generator.size() / coarse;
  block.reserve(generator);
  // Fine n = r + stride s meets coarse k in generator_{r + stride (s - k)}: row k - s of the
  // pattern.
  for (Eigen::Index r = 0; r < block.period_; ++r) {
    for (Eigen::Index row = 0; row < coarse; ++row) {
      block.append_pattern(row, generator[r + block.period_ * (row == 0 ? 0 : coarse - row)]);
    }
    block.end_pattern();
  }
  return block;
}

Eigen::Index StridedBlock::non_zeros() const {
  return cols_ / period_ * static_cast<Eigen::Index>(row_.size());
}

StridedBlock::Columns::Columns(const StridedBlock& block)
    : block_(&block), wraps_(block.begin_.begin() + 1, block.begin_.end()) {}

void StridedBlock::Columns::append_next(int row_offset, int*& row, double*& value) {
  const StridedBlock& block = *block_;
  const std::size_t begin = block.begin_[pattern_], end = block.begin_[pattern_ + 1];
  const int rows = static_cast<int>(block.rows_);
  // The pattern's entries from here on wrap around: a few more each time that it is moved down.
  std::size_t& wraps = wraps_[pattern_];
  while (wraps > begin && block.row_[wraps - 1] + shift_ >= rows) --wraps;
  const auto append = [&](std::size_t first, std::size_t last, int down) {
    const int* const from_row = block.row_.data() + first;
    const double* const from_value = block.value_.data() + first;
    int* const to_row = row;
    double* const to_value = value;
    const std::size_t count = last - first;
    for (std::size_t i = 0; i < count; ++i) {
      to_row[i] = from_row[i] + down;
      to_value[i] = from_value[i];
    }
    row += count;
    value += count;
  };
  append(wraps, end, row_offset + shift_ - rows);
  append(begin, wraps, row_offset + shift_);
  if (++pattern_ == wraps_.size()) {
    pattern_ = 0;
    shift_ += static_cast<int>(block.step_);
  }
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
    std::vector<StridedBlock::Columns> columns(column_of_blocks.begin(), column_of_blocks.end());
    for (Eigen::Index k = 0; k < column_of_blocks.front().cols(); ++k) {
      int row_offset = 0;
      for (std::size_t i = 0; i < columns.size(); ++i) {
        columns[i].append_next(row_offset, row, value);
        row_offset += static_cast<int>(column_of_blocks[i].rows());
      }
      *++column_begin = static_cast<int>(row - result.innerIndexPtr());
    }
  }
  return result;
}

}  // namespace wavecurve
