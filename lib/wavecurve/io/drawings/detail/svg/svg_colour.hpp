#pragma once

#include <optional>
#include <string_view>

#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::io {

struct TransparentColour {
  Colour colour;
  double opacity = 1;
};

/// A colour of CSS: by name, #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), rgba(), hsl(), hsla() or
/// transparent; or nothing.
std::optional<TransparentColour> parse_css_colour(std::string_view text);

}  // namespace wavecurve::io
