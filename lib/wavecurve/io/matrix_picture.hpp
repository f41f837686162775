#pragma once

#include <string>
#include <vector>

#include <Eigen/SparseCore>

namespace wavecurve::io {

struct MatrixPictureText {
  std::string title;
  std::string description;  ///< read out by screen readers
  std::string quantity;     ///< label of the colour bar, with the unit
};

/// An SVG picture of the magnitudes of a matrix on a logarithmic colour scale, white for zero,
/// darker for larger (monotone in luminance, so that it reads in grey), with the borders of blocks,
/// row and column index along the axes, and a colour bar. The scale spans at most 12 decades below
/// the largest magnitude; what is smaller has the lightest colour. Matrices of more than 256 rows
/// or columns are shown by the largest magnitude in each of at most 256 x 256 cells. `borders`: the
/// first index of each block after the first, of rows and columns alike.
std::string matrix_picture(const Eigen::SparseMatrix<double>& matrix,
                           const std::vector<Eigen::Index>& borders, const MatrixPictureText& text);

}  // namespace wavecurve::io
