#pragma once

#include <vector>

#include "wavecurve/curves/path.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_length.hpp"
#include "wavecurve/io/drawings/detail/svg/xml_element.hpp"

namespace wavecurve::io {

/// Whether an element draws: path, rect, circle, ellipse, line, polyline or polygon.
bool is_shape(const XmlElement& element);

/// What it draws, in its own coordinates; nothing where it has no size. Throws
/// std::invalid_argument naming the attribute, its value and what it should be.
std::vector<Subpath> outline_of(const XmlElement& shape, const Viewport& viewport);

}  // namespace wavecurve::io
