#pragma once

#include <string>
#include <utility>
#include <vector>

#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::io {

/// A colour as #rrggbb; components beyond 0 .. 1 are clamped.
std::string hex_colour(const Colour& colour);

/// What SVG calls a cap and a join.
std::string name_of(LineCap cap);
std::string name_of(LineJoin join);

/// A paint as SVG presentation attributes, name and value, in a fixed order; always the same names
/// for paints that agree in having a fill and a stroke.
std::vector<std::pair<std::string, std::string>> svg_paint(const Paint& paint);

}  // namespace wavecurve::io
