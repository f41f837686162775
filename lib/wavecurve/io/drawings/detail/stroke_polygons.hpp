#pragma once

#include <vector>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::io {

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
