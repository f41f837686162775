#pragma once

#include <vector>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::io {

/// Which share of every pixel is covered, row by row; pixel (i, j) is the square [i, i+1] x [j,
/// j+1].
class Coverage {
 public:
  Coverage(int width, int height);

  /// The area inside closed polygons, instead of what was covered before.
  void fill(const std::vector<Contour>& polygons, FillRule rule);

  int first_row() const { return first_row_; }
  int end_row() const { return end_row_; }
  /// Outside these columns nothing is covered.
  int first_column() const { return first_column_; }
  int end_column() const { return end_column_; }
  /// The shares of a row, 0 .. 1 up to rounding.
  const float* row(int y) const { return shares_.data() + static_cast<std::ptrdiff_t>(y) * width_; }

 private:
  void clear();
  /// Adds the part of a scan line between two abscissae.
  void add_span(int y, double from, double to);

  int width_, height_, first_row_ = 0, end_row_ = 0, first_column_ = 0, end_column_ = 0;
  std::vector<float> shares_;
};

}  // namespace wavecurve::io
