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

  /// The area inside closed polygons.
  void fill(const std::vector<Contour>& polygons, FillRule rule);

  int first_row() const { return first_row_; }
  int end_row() const { return end_row_; }
  /// The shares of a row, 0 .. 1 up to rounding.
  const float* row(int y) const { return shares_.data() + static_cast<std::ptrdiff_t>(y) * width_; }

 private:
  /// Adds the part of a scan line between two abscissae.
  void add_span(int y, double from, double to);

  int width_, height_, first_row_ = 0, end_row_ = 0;
  std::vector<float> shares_;
};

/// What a stroke is drawn with; the radius, half the width, in pixels.
struct Pen {
  double radius = 0;
  LineCap cap = LineCap::butt;
  LineJoin join = LineJoin::miter;
  double miter_limit = 4;
};

/// The stroke of lines, which are closed but those that are `open`, as polygons to be filled by the
/// nonzero rule: a rectangle an edge, in one where their sides nearly meet, the caps, and at another vertex a
/// wedge, and what of the join shows beyond it. A line without length has its caps alone, as SVG has it. In pixels.
std::vector<Contour> stroke_polygons(const std::vector<Contour>& lines,
                                     const std::vector<bool>& open, const Pen& pen);

}  // namespace wavecurve::io
