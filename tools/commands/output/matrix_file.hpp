#pragma once

#include <string>
#include <vector>

#include <Eigen/SparseCore>

#include "wavecurve/io/matrix_picture.hpp"

namespace wavecurve::tools {

/// Throws std::invalid_argument unless `output` is empty or ends in .mtx or .svg.
void check_matrix_ending(const std::string& output);

/// Writes the matrix (.mtx, MatrixMarket) or its picture (.svg); nothing if `output` is empty.
void write_matrix(const std::string& output, const Eigen::SparseMatrix<double>& matrix,
                  const std::vector<Eigen::Index>& borders, const io::MatrixPictureText& text);

}  // namespace wavecurve::tools
