#include "wavecurve/io/drawings/detail/svg/layer_names.hpp"

#include <fmt/format.h>

#include "wavecurve/io/drawings/detail/svg/svg_element.hpp"

namespace wavecurve::io {

namespace {

/// As programs write ids: the element's name, or that of its kind, and a number.
bool only_numbers(std::string_view id, std::string_view element) {
  if (!id.starts_with(element)) return false;
  id.remove_prefix(element.size());
  while (id.starts_with('-') || id.starts_with('_')) id.remove_prefix(1);
  return id.find_first_not_of("0123456789-") == std::string_view::npos;
}

/// The label of the nearest group that has one.
std::string_view label_around(const XmlElement& shape) {
  for (const XmlElement* up = shape.parent; up; up = up->parent) {
    if (const auto label = up->attribute("inkscape:label"); !label.empty()) return label;
  }
  return {};
}

}  // namespace

LayerNames::Name LayerNames::name_of(const XmlElement& shape, std::string_view use_id,
                                     bool is_copy) {
  const int number = ++shapes_of_name_[shape.name];
  if (!use_id.empty()) return {std::string(use_id), true};
  const bool is_kept = is_copy && is_drawn_in_place(shape);
  if (const auto label = shape.attribute("inkscape:label"); !label.empty()) {
    return {std::string(label), !is_kept};
  }
  const std::string_view id = shape.attribute("id");
  if (id.empty() || only_numbers(id, shape.name)) {
    if (const auto label = label_around(shape); !label.empty())
      return {std::string(label), !is_kept};
  }
  if (!id.empty()) return {std::string(id), !is_kept};
  return {fmt::format("{}-{}", shape.name, number), false};
}

std::string LayerNames::unique(const Name& name) {
  if ((name.given || !elements_.contains(name.text)) && ids_.insert(name.text).second) {
    return name.text;
  }
  for (int& copies = copies_[name.text];;) {
    std::string id = fmt::format("{}-{}", name.text, ++copies + 1);
    if (!elements_.contains(id) && ids_.insert(id).second) return id;
  }
}

}  // namespace wavecurve::io
