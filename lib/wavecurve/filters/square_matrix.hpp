#pragma once

#include <cstddef>
#include <vector>

namespace wavecurve {

/// A dense square matrix by rows, for the scalars that Eigen does not know as well as for double.
/// Scalar is double, certified::Ball or certified::Rational.
template <class Scalar>
class SquareMatrix {
 public:
  explicit SquareMatrix(int size)
      : size_(size), entries_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}
  int size() const { return size_; }
  Scalar& operator()(int row, int column) { return entries_[position(row, column)]; }
  const Scalar& operator()(int row, int column) const { return entries_[position(row, column)]; }
  /// The entries, row after row.
  const Scalar* data() const { return entries_.data(); }

 private:
  std::size_t position(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) +
           static_cast<std::size_t>(column);
  }
  int size_;
  std::vector<Scalar> entries_;
};

}  // namespace wavecurve
