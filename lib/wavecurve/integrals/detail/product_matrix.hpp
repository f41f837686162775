#pragma once

#include <cmath>

#include <Eigen/Core>

#include "wavecurve/integrals/detail/product_system.hpp"

namespace wavecurve {

/// I - 2^-p A_0, for p = 0 + u 1^T (product_system.hpp), in double precision.
inline Eigen::MatrixXd product_matrix(const ShiftSpace& space, const ProductMask<double>& mask,
                                      int power) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(space.size(), space.size());
  const double scale = std::ldexp(1.0, -power);
  for (int row = 0; row < space.size(); ++row) {
    visit_row(space, mask, row,
              [&](int unknown, double value) { matrix(row, unknown) -= scale * value; });
    matrix(row, row) += 1;
  }
  if (power > 0) return matrix;
  const double u = 1 / tuples_rounded_up(space);
  for (int column = 0; column < space.size(); ++column) {
    matrix.col(column).array() += u * space.multiplicity(column);
  }
  return matrix;
}

}  // namespace wavecurve
