#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace wavecurve {

/// A block between a fine band (or the samples) and a coarse band of `fine = stride * coarse`
/// functions, invariant under shifts: the entry of fine n and coarse k is
///   generator_{(n - stride k) mod fine}.
/// Stored by the distinct columns only: column c holds the pattern of c mod period, moved down by
/// step * (c / period) rows, cyclically. Zeros of the generator are left out.
class StridedBlock {
 public:
  using Generator = Eigen::Ref<const Eigen::VectorXd>;

  /// Rows are the fine functions, columns the coarse ones.
  static StridedBlock with_fine_rows(const Generator& generator, Eigen::Index coarse);
  /// The transpose: rows are the coarse functions, columns the fine ones.
  static StridedBlock with_fine_columns(const Generator& generator, Eigen::Index coarse);

  Eigen::Index rows() const { return rows_; }
  Eigen::Index cols() const { return cols_; }
  Eigen::Index non_zeros() const;
  class Columns;

 private:
  void reserve(const Generator& generator);
  void append_pattern(Eigen::Index row, double value);
  void end_pattern();

  Eigen::Index rows_ = 0, cols_ = 0, period_ = 1, step_ = 1;
  std::vector<std::size_t> begin_{0};  ///< pattern i is begin_[i] .. begin_[i + 1] - 1
  std::vector<int> row_;
  std::vector<double> value_;
};

/// A block's columns from the first on, without divisions or searches.
class StridedBlock::Columns {
 public:
  explicit Columns(const StridedBlock& block);
  /// Appends the next column's entries by ascending row; the pointers are moved behind them.
  void append_next(int row_offset, int*& row, double*& value);

 private:
  const StridedBlock* block_;
  std::size_t pattern_ = 0;
  int shift_ = 0;
  std::vector<std::size_t> wraps_;  ///< of each pattern
};

/// Throws std::invalid_argument if a sparse matrix cannot hold that many, its indices being int.
void check_non_zeros(Eigen::Index count);

/// blocks[c][r] is the block in column c and row r of the grid. Time and memory are proportional to
/// the non-zeros: columns are written in order into exactly reserved arrays.
/// Throws as check_non_zeros does.
Eigen::SparseMatrix<double> assemble(const std::vector<std::vector<StridedBlock>>& blocks);

}  // namespace wavecurve
