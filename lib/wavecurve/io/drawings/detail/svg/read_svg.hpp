#pragma once

#include <string_view>

#include "wavecurve/io/drawings/read_drawing.hpp"

namespace wavecurve::io {

/// The drawing that the text of an SVG file shows, or one element of it by its id. What read_drawing says holds; the messages do
/// not name the file.
DrawingFile read_svg(std::string_view text, std::string_view id = {});

}  // namespace wavecurve::io
