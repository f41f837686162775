#include "wavecurve/io/drawings/detail/svg/svg_colour.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "wavecurve/io/drawings/detail/svg/svg_length.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_values.hpp"
#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

/// A number, or a share of 1 in percent; `whole` is what the number 1 stands for.
std::optional<double> component(std::string_view text, double whole) {
  const bool percent = text.ends_with('%');
  if (percent) text.remove_suffix(1);
  const auto value = parse_number(text);
  if (!value) return std::nullopt;
  return std::clamp(*value / (percent ? 100 : whole), 0.0, 1.0);
}

std::optional<double> hue_in_degrees(std::string_view text) {
  if (text.ends_with("deg")) text.remove_suffix(3);
  const auto value = parse_number(text);
  if (!value) return std::nullopt;
  const double hue = std::fmod(*value, 360);
  return hue < 0 ? hue + 360 : hue;
}

/// CSS Color 4, section 7.1: saturation and lightness 0 .. 1.
Colour colour_of_hsl(double hue, double saturation, double lightness) {
  const double amplitude = saturation * std::min(lightness, 1 - lightness);
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue / 30, 12);
    return lightness - amplitude * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}));
  };
  return {channel(0), channel(8), channel(4)};
}

std::optional<TransparentColour> parse_function(std::string_view name, std::string_view arguments) {
  const auto pieces = split(arguments, " ,/\t\r\n");
  if (pieces.size() < 3 || pieces.size() > 4) return std::nullopt;
  const auto opacity = pieces.size() == 4 ? component(pieces[3], 1) : 1.0;
  if (name == "rgb" || name == "rgba") {
    const auto r = component(pieces[0], 255), g = component(pieces[1], 255),
               b = component(pieces[2], 255);
    if (r && g && b && opacity) return TransparentColour{{*r, *g, *b}, *opacity};
  } else if (name == "hsl" || name == "hsla") {
    const auto hue = hue_in_degrees(pieces[0]);
    const auto saturation = component(pieces[1], 100), lightness = component(pieces[2], 100);
    if (hue && saturation && lightness && opacity) {
      return TransparentColour{colour_of_hsl(*hue, *saturation, *lightness), *opacity};
    }
  }
  return std::nullopt;
}

std::optional<TransparentColour> parse_hex_with_opacity(const std::string& text) {
  const std::size_t digits = text.size() / 4;
  const auto colour = parse_colour(std::string_view(text).substr(0, 1 + 3 * digits));
  std::string opacity = text.substr(1 + 3 * digits);
  if (digits == 1) opacity += opacity;
  const auto opaque = parse_colour("#" + opacity + "0000");
  if (!colour || !opaque) return std::nullopt;
  return TransparentColour{*colour, opaque->red};
}

}  // namespace

std::optional<TransparentColour> parse_css_colour(std::string_view text) {
  const std::string colour = lower_case(trimmed(text));
  if (colour == "transparent") return TransparentColour{{}, 0};
  if (colour.starts_with('#') && (colour.size() == 5 || colour.size() == 9)) {
    return parse_hex_with_opacity(colour);
  }
  if (const std::size_t open = colour.find('('); open != colour.npos && colour.ends_with(')')) {
    return parse_function(trimmed(std::string_view(colour).substr(0, open)),
                          std::string_view(colour).substr(open + 1, colour.size() - open - 2));
  }
  if (const auto known = parse_colour(colour)) return TransparentColour{*known, 1};
  return std::nullopt;
}

}  // namespace wavecurve::io
