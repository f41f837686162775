#include "wavecurve/io/drawings/detail/svg/svg_style.hpp"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

/// Reads the properties of one element.
class StyleReader {
 public:
  StyleReader(const XmlElement& element, const Viewport& viewport, const StyleSource& source)
      : properties_(source.sheet.cascade(element)), viewport_(viewport), source_(source) {}

  Style read(Style style) const {
    read_colour("color", style.colour, style.colour);
    read_paint("fill", style.fill, style.colour);
    read_paint("stroke", style.stroke, style.colour);
    read_opacity("fill-opacity", style.fill_opacity);
    read_opacity("stroke-opacity", style.stroke_opacity);
    double own_opacity = 1;
    read_opacity("opacity", own_opacity);
    style.opacity *= own_opacity;
    read_stroke_width(style.stroke_width);
    read_pen(style);
    read_keywords(style);
    read_own(style);
    warn_of_unsupported();
    return style;
  }

  TransparentColour read_stop(const TransparentColour& current) const {
    TransparentColour stop;
    double opacity = 1;
    read_colour("stop-color", stop, current);
    read_opacity("stop-opacity", opacity);
    stop.opacity *= opacity;
    return stop;
  }

 private:
  /// The value of a property, or nothing where it is not given or inherited.
  std::string_view given(std::string_view property) const {
    const auto found = properties_.find(property);
    if (found == properties_.end() || found->second == "inherit") return {};
    return found->second;
  }
  void warn_of_value(std::string_view property, std::string_view value) const {
    source_.warnings.add("the {} '{}' is not supported", property, shown(value));
  }

  void read_colour(std::string_view property, TransparentColour& colour,
                   const TransparentColour& current) const {
    const std::string_view value = given(property);
    if (value.empty()) return;
    if (lower_case(value) == "currentcolor") {
      colour = current;
    } else if (const auto parsed = parse_css_colour(value)) {
      colour = *parsed;
    } else {
      warn_of_value(property, value);
    }
  }

  void read_paint(std::string_view property, PaintServer& paint,
                  const TransparentColour& current) const {
    if (const std::string_view value = given(property); !value.empty()) {
      set_paint(property, value, paint, current);
    }
  }
  void set_paint(std::string_view property, std::string_view value, PaintServer& paint,
                 const TransparentColour& current) const {
    using Kind = PaintServer::Kind;
    if (lower_case(value) == "none") {
      paint.kind = Kind::none;
    } else if (lower_case(value) == "currentcolor") {
      paint.kind = Kind::current_colour;
    } else if (value.starts_with("url(")) {
      set_reference(property, value, paint, current);
    } else if (const auto colour = parse_css_colour(value)) {
      paint = {Kind::colour, *colour};
    } else {
      warn_of_value(property, value);
    }
  }

  /// url(#id), with an optional colour for readers that know no such thing.
  void set_reference(std::string_view property, std::string_view value, PaintServer& paint,
                     const TransparentColour& current) const {
    const std::size_t end = std::min(value.find(')'), value.size());
    const std::string id = referred_id(value);
    const auto found = source_.elements.find(id);
    const auto mean =
        found == source_.elements.end() ? std::nullopt : mean_colour(*found->second, current);
    if (mean) {
      source_.warnings.add("the gradient '{}' is replaced by its mean colour", shown(id));
      paint = {PaintServer::Kind::colour, *mean};
      return;
    }
    source_.warnings.add("the {} '{}' is no gradient with colours", property, shown(value));
    const std::string_view instead = trimmed(value.substr(std::min(end + 1, value.size())));
    paint.kind = PaintServer::Kind::none;
    if (!instead.empty() && !instead.starts_with("url(")) {
      set_paint(property, instead, paint, current);
    }
  }

  /// The mean colour of the stops of a gradient, or of the gradient that it refers to.
  std::optional<TransparentColour> mean_colour(const XmlElement& first,
                                               const TransparentColour& current) const {
    const XmlElement* gradient = &first;
    constexpr int most_references = 16;
    for (int i = 0; i < most_references; ++i) {
      if (gradient->name != "linearGradient" && gradient->name != "radialGradient") break;
      TransparentColour sum{{}, 0};
      double count = 0;
      for (const auto& child : gradient->children) {
        if (child->name != "stop") continue;
        const TransparentColour stop = StyleReader(*child, viewport_, source_).read_stop(current);
        sum.colour.red += stop.colour.red;
        sum.colour.green += stop.colour.green;
        sum.colour.blue += stop.colour.blue;
        sum.opacity += stop.opacity;
        ++count;
      }
      if (count > 0) {
        return TransparentColour{
            {sum.colour.red / count, sum.colour.green / count, sum.colour.blue / count},
            sum.opacity / count};
      }
      std::string_view reference = gradient->attribute("href");
      if (!reference.starts_with('#')) break;
      const auto found = source_.elements.find(reference.substr(1));
      if (found == source_.elements.end()) break;
      gradient = found->second;
    }
    return std::nullopt;
  }

  void read_opacity(std::string_view property, double& opacity) const {
    const std::string_view value = given(property);
    if (value.empty()) return;
    if (const auto parsed = parse_length(value, 1)) {
      opacity = std::clamp(*parsed, 0.0, 1.0);
    } else {
      warn_of_value(property, value);
    }
  }

  void read_stroke_width(double& width) const {
    const std::string_view value = given("stroke-width");
    if (value.empty()) return;
    const auto parsed = parse_length(value, viewport_.diagonal());
    if (parsed && *parsed >= 0 && *parsed <= 1e9) {
      width = *parsed;
    } else {
      warn_of_value("stroke-width", value);
    }
  }

  void read_pen(Style& style) const {
    style.scales_stroke = given("vector-effect") != "non-scaling-stroke";
    if (const auto order = given("paint-order"); !order.empty()) {
      style.stroke_first = order.find("stroke") < order.find("fill") && order != "normal";
    }
    using enum LineCap;
    read_choice("stroke-linecap", {{"butt", butt}, {"round", round}, {"square", square}},
                style.line_cap);
    read_choice(
        "stroke-linejoin",
        {{"miter", LineJoin::miter}, {"round", LineJoin::round}, {"bevel", LineJoin::bevel}},
        style.line_join);
    const std::string_view limit = given("stroke-miterlimit");
    if (limit.empty()) return;
    if (const auto parsed = parse_length(limit, 1); parsed && *parsed >= 1) {
      style.miter_limit = *parsed;
    } else {
      warn_of_value("stroke-miterlimit", limit);
    }
  }

  template <class Value>
  void read_choice(std::string_view property,
                   std::initializer_list<std::pair<std::string_view, Value>> choices,
                   Value& chosen) const {
    const std::string_view value = given(property);
    if (value.empty()) return;
    for (const auto& [name, choice] : choices) {
      if (name != lower_case(value)) continue;
      chosen = choice;
      return;
    }
    warn_of_value(property, value);
  }

  void read_keywords(Style& style) const {
    if (const auto value = given("fill-rule"); !value.empty()) {
      style.fill_rule = value == "evenodd" ? FillRule::evenodd : FillRule::nonzero;
    }
    if (const auto value = given("visibility"); !value.empty()) style.visible = value == "visible";
    if (given("display") == "none") style.displayed = false;
  }

  void read_own(Style& style) const {
    style.own.clear();
    for (std::string_view property :
         {"clip-path", "clip-rule", "cx", "cy", "d", "height", "r", "rx", "ry", "transform",
          "transform-origin", "width", "x", "y"}) {
      if (const auto value = given(property); !value.empty()) style.own.emplace(property, value);
    }
  }

  void warn_of_unsupported() const {
    for (std::string_view property :
         {"mask", "filter", "marker", "marker-start", "marker-mid", "marker-end",
          "stroke-dasharray", "rotate", "scale", "translate", "transform-box"}) {
      const std::string_view value = given(property);
      if (!value.empty() && value != "none") {
        source_.warnings.add("the property {} is not supported", property);
      }
    }
  }

  Properties properties_;
  const Viewport& viewport_;
  const StyleSource& source_;
};

/// The colour of a paint, and its own opacity multiplied into the one given.
std::optional<Colour> resolve(const PaintServer& paint, const TransparentColour& current,
                              double& opacity) {
  if (paint.kind == PaintServer::Kind::none) return std::nullopt;
  const bool is_current = paint.kind == PaintServer::Kind::current_colour;
  const TransparentColour& colour = is_current ? current : paint.colour;
  opacity *= colour.opacity;
  return colour.colour;
}

}  // namespace

std::string referred_id(std::string_view value) {
  std::string id;
  if (!value.starts_with("url(")) return id;
  for (const char c : value.substr(4, std::min(value.find(')'), value.size()) - 4)) {
    if (c != '"' && c != '\'' && c != ' ') id += c;
  }
  if (id.starts_with('#')) id.erase(0, 1);
  return id;
}

Style style_of(const XmlElement& element, const Style& parent, const Viewport& viewport,
               const StyleSource& source) {
  return StyleReader(element, viewport, source).read(parent);
}

Paint paint_of(const Style& style, double scale) {
  Paint paint;
  paint.fill_opacity = style.opacity * style.fill_opacity;
  paint.stroke_opacity = style.opacity * style.stroke_opacity;
  paint.fill = resolve(style.fill, style.colour, paint.fill_opacity);
  paint.stroke = resolve(style.stroke, style.colour, paint.stroke_opacity);
  paint.stroke_width = (style.scales_stroke ? scale : 1) * style.stroke_width;
  if (paint.stroke_width == 0) paint.stroke.reset();
  paint.fill_rule = style.fill_rule;
  paint.line_cap = style.line_cap;
  paint.line_join = style.line_join;
  paint.miter_limit = style.miter_limit;
  return paint;
}

}  // namespace wavecurve::io
