#pragma once

#include <map>

#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/io/drawings/detail/svg/style_sheet.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_colour.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_length.hpp"

namespace wavecurve::io {

/// The elements that have ids.
using ElementIndex = std::map<std::string, const XmlElement*, std::less<>>;

/// What the values of properties are read with.
struct StyleSource {
  const StyleSheet& sheet;
  const ElementIndex& elements;
  Warnings& warnings;
};

/// `fill` or `stroke`: a colour, the value of `color`, or nothing.
struct PaintServer {
  enum class Kind { none, colour, current_colour } kind = Kind::none;
  TransparentColour colour;
};

/// The values of properties that an element has, by itself or from its parents.
struct Style {
  PaintServer fill{PaintServer::Kind::colour, {}}, stroke;
  TransparentColour colour;  ///< the property `color`
  double fill_opacity = 1, stroke_opacity = 1, stroke_width = 1;
  double opacity = 1;  ///< the product over the groups
  FillRule fill_rule = FillRule::nonzero;
  LineCap line_cap = LineCap::butt;
  LineJoin line_join = LineJoin::miter;
  double miter_limit = 4;
  bool stroke_first = false;  ///< by paint-order
  bool scales_stroke = true;  ///< not by vector-effect, which is not inherited
  bool visible = true, displayed = true;
  Properties
      own;  ///< of the element alone: its geometry, where CSS gives it, transform, and the like
};

/// The id in a reference url(#id), in quotes or not.
std::string referred_id(std::string_view value);

/// The style of a child element. Gradients become their mean colour, with a warning; so does
/// everything named that is not supported.
Style style_of(const XmlElement& element, const Style& parent, const Viewport& viewport,
               const StyleSource& source);

/// How an outline in that style is painted when its coordinates are scaled by a factor.
Paint paint_of(const Style& style, double scale);

}  // namespace wavecurve::io
