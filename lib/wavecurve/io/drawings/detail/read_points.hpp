#pragma once

#include <string_view>

#include "wavecurve/io/drawings/read_drawing.hpp"

namespace wavecurve::io {

/// The drawing of one layer, `contour`, that the text of a CSV file of points gives. What
/// read_drawing says holds; the messages do not name the file.
DrawingFile read_points(std::string_view text, const PointOptions& options = {});

}  // namespace wavecurve::io
