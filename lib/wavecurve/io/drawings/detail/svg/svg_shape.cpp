#include "wavecurve/io/drawings/detail/svg/svg_shape.hpp"

#include <algorithm>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/io/drawings/detail/svg/arc.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_values.hpp"
#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

using Eigen::Vector2d;

/// Reads the lengths among the attributes of a shape.
struct Lengths {
  const XmlElement& shape;
  const Properties& properties;
  std::string& defect;  ///< of what is left out

  std::string_view text_of(std::string_view name) const {
    const auto property = properties.find(name);
    return trimmed(property != properties.end() ? property->second : shape.attribute(name));
  }
  /// Nothing where the attribute is absent or `auto`.
  std::optional<double> given(std::string_view name, double hundred_percent) const {
    const std::string_view text = text_of(name);
    if (text.empty() || text == "auto") return std::nullopt;
    const auto value = parse_length(text, hundred_percent);
    if (!value) {
      throw std::invalid_argument(fmt::format("{} '{}' is no finite length", name, shown(text)));
    }
    return value;
  }
  double at(std::string_view name, double hundred_percent) const {
    return given(name, hundred_percent).value_or(0);
  }
  std::optional<double> given_size(std::string_view name, double hundred_percent) const {
    const auto value = given(name, hundred_percent);
    if (value && *value < 0) {
      throw std::invalid_argument(fmt::format("{} {} is below 0", name, *value));
    }
    return value;
  }
  /// A radius below 0 counts as none given.
  std::optional<double> given_radius(std::string_view name, double hundred_percent) const {
    const auto value = given(name, hundred_percent);
    if (!value || *value >= 0) return value;
    defect = fmt::format("{} {} is below 0", name, *value);
    return std::nullopt;
  }
};

void draw_ellipse(PathBuilder& path, const Vector2d& centre, const Vector2d& radii) {
  if (!(radii.minCoeff() > 0)) return;
  const Ellipse ellipse{centre, radii};
  path.move_to(ellipse.at(0));
  append_arc(path, ellipse, 0, 2 * std::numbers::pi);
  path.move_end(ellipse.at(0));
  path.close();
}

void draw_rectangle(PathBuilder& path, const Lengths& lengths, const Viewport& viewport) {
  const Vector2d corner(lengths.at("x", viewport.width), lengths.at("y", viewport.height));
  const Vector2d size(lengths.given_size("width", viewport.width).value_or(0),
                      lengths.given_size("height", viewport.height).value_or(0));
  if (!(size.minCoeff() > 0)) return;
  const auto rx = lengths.given_radius("rx", viewport.width);
  const auto ry = lengths.given_radius("ry", viewport.height);
  const Vector2d wanted(rx.value_or(ry.value_or(0)), ry.value_or(rx.value_or(0)));
  const Vector2d radii = wanted.cwiseMin(size / 2);
  const bool round = radii.minCoeff() > 0;
  path.move_to(corner + Vector2d(round ? radii.x() : 0, 0));
  // The corners from the upper right one on, clockwise, and where the arc around each begins.
  const Vector2d corners[] = {{1, 0}, {1, 1}, {0, 1}, {0, 0}};
  for (int i = 0; i < 4; ++i) {
    const Vector2d at = corner + corners[i].cwiseProduct(size);
    const Vector2d inward = Vector2d::Ones() - 2 * corners[i];
    const Ellipse ellipse{at + inward.cwiseProduct(radii), radii};
    const double from = (i - 1) * std::numbers::pi / 2;
    if (!round) {
      if (i < 3) path.line_to(at);
      continue;
    }
    if ((path.current() - ellipse.at(from)).norm() > 1e-14 * size.norm()) {
      path.line_to(ellipse.at(from));
    }
    append_arc(path, ellipse, from, std::numbers::pi / 2);
  }
  path.close();
}

void draw_line(PathBuilder& path, const Lengths& lengths, const Viewport& viewport) {
  path.move_to({lengths.at("x1", viewport.width), lengths.at("y1", viewport.height)});
  path.line_to({lengths.at("x2", viewport.width), lengths.at("y2", viewport.height)});
}

/// The data of path("..."), as the property d has it, or of the attribute.
std::string_view path_data(const Lengths& lengths) {
  std::string_view data = lengths.text_of("d");
  if (!data.starts_with("path(")) return data;
  data = trimmed(data.substr(5, data.rfind(')') - 5));
  const bool quoted = data.size() > 1 && (data.front() == '"' || data.front() == '\'');
  return quoted ? data.substr(1, data.size() - 2) : data;
}

void draw(PathBuilder& path, const Lengths& lengths, const Viewport& viewport) {
  const XmlElement& shape = lengths.shape;
  const Vector2d centre(lengths.at("cx", viewport.width), lengths.at("cy", viewport.height));
  if (shape.name == "rect") {
    draw_rectangle(path, lengths, viewport);
  } else if (shape.name == "circle") {
    const double radius = lengths.given_size("r", viewport.diagonal()).value_or(0);
    draw_ellipse(path, centre, {radius, radius});
  } else if (shape.name == "ellipse") {
    const auto rx = lengths.given_radius("rx", viewport.width);
    const auto ry = lengths.given_radius("ry", viewport.height);
    draw_ellipse(path, centre, {rx.value_or(ry.value_or(0)), ry.value_or(rx.value_or(0))});
  } else if (shape.name == "line") {
    draw_line(path, lengths, viewport);
  } else if (shape.name == "path") {
    parse_path_data(path_data(lengths), path);
  } else {
    try {
      parse_points(shape.attribute("points"), path);
    } catch (const std::invalid_argument& error) {
      lengths.defect = error.what();
    }
    if (shape.name == "polygon") path.close();
  }
}

}  // namespace

bool is_shape(const XmlElement& element) {
  const std::string_view names[] = {"path", "rect",     "circle", "ellipse",
                                    "line", "polyline", "polygon"};
  return std::find(std::begin(names), std::end(names), element.name) != std::end(names);
}

ShapeOutline outline_of(const XmlElement& shape, const Properties& properties,
                        const Viewport& viewport) {
  PathBuilder path;
  ShapeOutline outline;
  try {
    draw(path, {shape, properties, outline.defect}, viewport);
  } catch (const std::invalid_argument& error) {
    outline.defect = error.what();
  }
  outline.subpaths = path.take();
  return outline;
}

}  // namespace wavecurve::io
