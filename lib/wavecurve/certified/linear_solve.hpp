#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/rational.hpp"

namespace wavecurve::certified {

/// A dense square matrix by rows. Scalar is Ball or Rational.
template <class Scalar>
class SquareMatrix {
 public:
  explicit SquareMatrix(int size)
      : size_(size), entries_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}
  int size() const { return size_; }
  Scalar& operator()(int row, int column) { return entries_[position(row, column)]; }
  const Scalar& operator()(int row, int column) const { return entries_[position(row, column)]; }

 private:
  std::size_t position(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) +
           static_cast<std::size_t>(column);
  }
  int size_;
  std::vector<Scalar> entries_;
};

/// The solution of A x = b, with proof that A is regular: every matrix in the enclosure A is. Empty
/// if that could not be proved at the working precision (Ball), or is not so (Rational).
std::optional<std::vector<Ball>> solve(const SquareMatrix<Ball>& a, const std::vector<Ball>& b);
std::optional<std::vector<Rational>> solve(const SquareMatrix<Rational>& a,
                                           const std::vector<Rational>& b);

}  // namespace wavecurve::certified
