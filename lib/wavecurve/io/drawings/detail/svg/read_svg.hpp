#pragma once

#include <string_view>

#include "wavecurve/io/drawings/read_drawing.hpp"

namespace wavecurve::io {

/// The drawing that the text of an SVG file shows. What read_drawing says holds; the messages do
/// not name the file.
DrawingFile read_svg(std::string_view text);

}  // namespace wavecurve::io
