#include "wavecurve/io/drawings/detail/svg/svg_element.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

std::string name_of(const XmlElement& element) {
  const std::string_view id = element.attribute("id");
  return id.empty() ? element.name : fmt::format("{} '{}'", element.name, shown(id));
}

bool is_never_drawn(std::string_view name) {
  constexpr std::string_view names[] = {"defs",     "symbol",   "title",          "desc",
                                        "metadata", "style",    "linearGradient", "radialGradient",
                                        "stop",     "clipPath", "mask",           "marker",
                                        "pattern",  "filter",   "view",           "script"};
  return name.empty() || std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool is_drawn_in_place(const XmlElement& element) {
  for (const XmlElement* up = &element; up; up = up->parent) {
    if (is_never_drawn(up->name)) return false;
  }
  return true;
}

bool meets_conditions(const XmlElement& element) {
  return element.attribute("requiredExtensions").empty() &&
         !element.attributes.contains("systemLanguage");
}

bool has_percentages(const XmlElement& element) {
  if (element.parent) {
    // Viewports within fill the window where nothing else is said.
    if (element.name == "svg" || element.name == "symbol") return true;
    for (const std::string_view name :
         {"x", "y", "width", "height", "cx", "cy", "r", "rx", "ry", "x1", "y1", "x2", "y2"}) {
      if (trimmed(element.attribute(name)).ends_with('%')) return true;
    }
  }
  return std::any_of(element.children.begin(), element.children.end(),
                     [](const auto& child) { return has_percentages(*child); });
}

}  // namespace wavecurve::io
