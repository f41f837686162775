#include "wavecurve/io/drawings/detail/svg_paint.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/decimals.hpp"

namespace wavecurve::io {

std::string hex_colour(const Colour& colour) {
  const auto channel = [](double value) {
    return static_cast<int>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(colour.red), channel(colour.green),
                     channel(colour.blue));
}

std::string name_of(LineCap cap) {
  return cap == LineCap::butt ? "butt" : cap == LineCap::round ? "round" : "square";
}

std::string name_of(LineJoin join) {
  return join == LineJoin::miter ? "miter" : join == LineJoin::round ? "round" : "bevel";
}

std::vector<std::pair<std::string, std::string>> svg_paint(const Paint& paint) {
  const Decimals opacity(3);
  std::vector<std::pair<std::string, std::string>> result;
  result.emplace_back("fill", paint.fill ? hex_colour(*paint.fill) : "none");
  if (paint.fill) {
    result.emplace_back("fill-opacity", opacity.text(paint.fill_opacity));
    result.emplace_back("fill-rule", paint.fill_rule == FillRule::evenodd ? "evenodd" : "nonzero");
  }
  if (paint.stroke) {
    result.emplace_back("stroke", hex_colour(*paint.stroke));
    result.emplace_back("stroke-opacity", opacity.text(paint.stroke_opacity));
    result.emplace_back("stroke-width", fmt::format("{:.6g}", paint.stroke_width));
    result.emplace_back("stroke-linecap", name_of(paint.line_cap));
    result.emplace_back("stroke-linejoin", name_of(paint.line_join));
    result.emplace_back("stroke-miterlimit", fmt::format("{:.6g}", paint.miter_limit));
  }
  return result;
}

}  // namespace wavecurve::io
