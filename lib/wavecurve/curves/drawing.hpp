#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wavecurve/curves/path.hpp"

namespace wavecurve {

/// A colour of the sRGB space, components 0 .. 1.
struct Colour {
  double red = 0, green = 0, blue = 0;
  bool operator==(const Colour&) const = default;
};

enum class FillRule { nonzero, evenodd };
enum class LineCap { butt, round, square };
enum class LineJoin { miter, round, bevel };

/// How an outline is painted, as SVG has it. Opacities multiply a group's into the fill's and the
/// stroke's own.
struct Paint {
  std::optional<Colour> fill, stroke;
  double fill_opacity = 1, stroke_opacity = 1;
  double stroke_width = 1;  ///< in units of the drawing
  FillRule fill_rule = FillRule::nonzero;
  LineCap line_cap = LineCap::butt;  ///< at the ends of open subpaths
  LineJoin line_join = LineJoin::miter;
  double miter_limit = 4;  ///< a miter longer than this, in widths of the stroke, is a bevel
  bool operator==(const Paint&) const = default;
};

/// One painted outline: an SVG shape, with all transformations applied. Further subpaths are holes
/// or separate pieces, as the fill rule has it.
struct Layer {
  std::string id;  ///< unique in the drawing
  std::vector<Subpath> subpaths;
  Paint paint;
};

struct ViewBox {
  double x = 0, y = 0, width = 0, height = 0;
  bool operator==(const ViewBox&) const = default;
};

/// Layers in painting order, the lowest first; x points right, y points down.
struct Drawing {
  ViewBox view_box;
  std::vector<Layer> layers;
};

}  // namespace wavecurve
