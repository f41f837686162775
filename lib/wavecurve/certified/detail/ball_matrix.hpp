#pragma once

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/detail/flint_matrices.hpp"
#include "wavecurve/filters/square_matrix.hpp"

namespace wavecurve::certified {

/// Owns a matrix of Arb, for its functions on whole matrices.
class BallMatrix {
 public:
  BallMatrix(long rows, long columns) { arb_mat_init(value, rows, columns); }
  explicit BallMatrix(const SquareMatrix<Ball>& a) : BallMatrix(a.size(), a.size()) {
    for (int i = 0; i < a.size(); ++i) {
      for (int j = 0; j < a.size(); ++j) set(i, j, a(i, j));
    }
  }
  BallMatrix(BallMatrix&& other) noexcept : BallMatrix(0, 0) { arb_mat_swap(value, other.value); }
  BallMatrix(const BallMatrix&) = delete;
  BallMatrix& operator=(const BallMatrix&) = delete;
  ~BallMatrix() { arb_mat_clear(value); }

  void set(long row, long column, const Ball& entry) {
    arb_set(arb_mat_entry(value, row, column), entry.get());
  }
  Ball get(long row, long column) const {
    Ball entry;
    arb_set(entry.get(), arb_mat_entry(value, row, column));
    return entry;
  }

  arb_mat_t value;
};

}  // namespace wavecurve::certified
