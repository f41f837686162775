#pragma once

#include <string>
#include <vector>

#include "wavecurve/curves/path.hpp"
#include "wavecurve/io/drawings/detail/svg/style_sheet.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_length.hpp"
#include "wavecurve/io/drawings/detail/svg/xml_element.hpp"

namespace wavecurve::io {

/// Whether an element draws: path, rect, circle, ellipse, line, polyline or polygon.
bool is_shape(const XmlElement& element);

/// What a shape draws, in its own coordinates, and what is wrong with it.
struct ShapeOutline {
  std::vector<Subpath> subpaths;  ///< nothing where it has no size
  std::string defect;  ///< naming the attribute, its value and what it should be, if anything
};

/// If data are broken, the part before the defect is drawn; if sizes are, nothing. Lengths are those of the
/// properties, where they are given, else of the attributes.
ShapeOutline outline_of(const XmlElement& shape, const Properties& properties,
                        const Viewport& viewport);

}  // namespace wavecurve::io
