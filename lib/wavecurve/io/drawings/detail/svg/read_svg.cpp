#include "wavecurve/io/drawings/detail/svg/read_svg.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/io/drawings/detail/svg/fit_view_box.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_shape.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_style.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_values.hpp"
#include "wavecurve/io/drawings/detail/svg/tidy_outline.hpp"
#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

constexpr std::size_t most_layers = 100'000, most_segments = 4'000'000;
constexpr int most_elements_drawn = 1'000'000;

/// What holds where an element is drawn.
struct Scene {
  Eigen::Affine2d transform = Eigen::Affine2d::Identity();
  Style style;
  Viewport viewport;
  std::string_view use_id;  ///< of the <use> that the element is drawn for, directly
};

std::string name_of(const XmlElement& element) {
  const std::string_view id = element.attribute("id");
  return id.empty() ? element.name : fmt::format("{} '{}'", element.name, shown(id));
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Draws nothing where it stands.
bool is_never_drawn(std::string_view name) {
  return name.empty() || is_one_of(name, {"defs", "symbol", "title", "desc", "metadata", "style",
                                          "linearGradient", "radialGradient", "stop", "clipPath",
                                          "mask", "marker", "pattern", "filter", "view"});
}

class SvgReader {
 public:
  explicit SvgReader(const XmlElement& root) : root_(root) { index(root); }

  DrawingFile read() {
    if (root_.name != "svg") {
      throw std::invalid_argument(
          fmt::format("line {}: the root element is {}, not svg", root_.line, root_.name));
    }
    Scene scene;
    read_view_box(scene);
    draw(root_, scene);
    if (file_.drawing.layers.empty()) {
      throw std::invalid_argument(nothing_drawn_.empty() ? "nothing is painted: no path or shape"
                                                         : "nothing is painted: " + nothing_drawn_);
    }
    if (file_.drawing.view_box.width == 0) file_.drawing.view_box = fit_view_box(file_.drawing);
    file_.warnings = warnings_.list();
    return std::move(file_);
  }

 private:
  void index(const XmlElement& element) {
    if (const auto id = element.attribute("id"); !id.empty()) elements_.emplace(id, &element);
    if (element.name == "style") sheet_.add(element.text, warnings_);
    for (const auto& child : element.children) index(*child);
  }

  void read_view_box(Scene& scene) {
    ViewBox& box = file_.drawing.view_box;
    at(root_, [&] {
      if (const auto text = trimmed(root_.attribute("viewBox")); !text.empty()) {
        box = parse_view_box(text);
      } else {
        // Percentages refer to a window that is not there.
        const auto width = parse_length(root_.attribute("width"), 0);
        const auto height = parse_length(root_.attribute("height"), 0);
        if (width && height && *width > 0 && *height > 0) box = {0, 0, *width, *height};
      }
    });
    scene.viewport = {box.width, box.height};
  }

  /// Adds to the messages of an action where in the file it happened.
  template <typename Action>
  void at(const XmlElement& element, const Action& action) const {
    try {
      action();
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(
          fmt::format("line {}: {}: {}", element.line, name_of(element), error.what()));
    }
  }
  [[noreturn]] void refuse(const XmlElement& element, const std::string& defect) const {
    throw std::invalid_argument(
        fmt::format("line {}: {}: {}", element.line, name_of(element), defect));
  }

  void draw(const XmlElement& element, Scene scene) {
    if (++elements_drawn_ > most_elements_drawn) {
      refuse(element, fmt::format("more than {} elements are drawn", most_elements_drawn));
    }
    if (++depth_ > deepest_nesting) {
      refuse(element, fmt::format("more than {} elements in each other", deepest_nesting));
    }
    const StyleSource source{sheet_, elements_, warnings_};
    const double outer_opacity = scene.style.opacity;
    scene.style = style_of(element, scene.style, scene.viewport, source);
    if (scene.style.displayed) {
      at_transform(element, scene);
      const std::size_t first = file_.drawing.layers.size();
      draw_kind(element, scene);
      if (scene.style.opacity < outer_opacity && !is_shape(element) &&
          file_.drawing.layers.size() > first + 1) {
        warnings_.add("the opacity of a group is given to each of its shapes");
      }
    }
    --depth_;
  }

  void at_transform(const XmlElement& element, Scene& scene) const {
    const std::string_view text = element.attribute("transform");
    if (text.empty()) return;
    at(element, [&] { scene.transform = scene.transform * parse_transform(text); });
  }

  void draw_kind(const XmlElement& element, const Scene& scene) {
    if (is_shape(element)) {
      draw_shape(element, scene);
    } else if (element.name == "use") {
      draw_use(element, scene);
    } else if (element.name == "svg" && &element != &root_) {
      draw_nested(element, scene, nullptr);
    } else if (is_one_of(element.name, {"svg", "g", "a", "switch"})) {
      draw_children(element, scene);
    } else if (!is_never_drawn(element.name)) {
      warn_of_element(element);
    }
  }

  void warn_of_element(const XmlElement& element) {
    warnings_.add("the element {} is not supported", shown(element.name));
  }

  void draw_children(const XmlElement& element, Scene scene) {
    scene.use_id = {};
    for (const auto& child : element.children) {
      if (is_never_drawn(child->name)) continue;
      draw(*child, scene);
      if (element.name == "switch") break;  // the rest is for readers that know less
    }
  }

  void draw_use(const XmlElement& use, Scene scene) {
    const std::string_view reference = use.attribute("href");
    const auto found =
        reference.starts_with('#') ? elements_.find(reference.substr(1)) : elements_.end();
    if (found == elements_.end()) {
      warnings_.add("use of '{}', which is not in the file", shown(reference));
      return;
    }
    const XmlElement& target = *found->second;
    if (std::find(used_.begin(), used_.end(), &target) != used_.end()) {
      refuse(use, fmt::format("uses '{}' within itself", shown(reference)));
    }
    const auto coordinate = [&](std::string_view name, double hundred_percent) {
      return parse_length(use.attribute(name), hundred_percent).value_or(0);
    };
    scene.transform.translate(Eigen::Vector2d(coordinate("x", scene.viewport.width),
                                              coordinate("y", scene.viewport.height)));
    scene.use_id = use.attribute("id");
    used_.push_back(&target);
    if (target.name == "symbol") {
      draw_symbol(target, scene, use);
    } else if (target.name == "svg") {
      draw_nested(target, scene, &use);
    } else {
      draw(target, scene);
    }
    used_.pop_back();
  }

  void draw_symbol(const XmlElement& symbol, Scene scene, const XmlElement& use) {
    const StyleSource source{sheet_, elements_, warnings_};
    scene.style = style_of(symbol, scene.style, scene.viewport, source);
    if (scene.style.displayed) draw_nested(symbol, scene, &use);
  }

  /// Draws into a viewport of its own; the size that a <use> gives comes before the element's.
  void draw_nested(const XmlElement& element, Scene scene, const XmlElement* use) {
    const auto length = [&](std::string_view name, double hundred_percent, double otherwise) {
      return parse_length(element.attribute(name), hundred_percent).value_or(otherwise);
    };
    const auto size = [&](std::string_view name, double hundred_percent) {
      const double own = length(name, hundred_percent, hundred_percent);
      return use ? parse_length(use->attribute(name), hundred_percent).value_or(own) : own;
    };
    const Viewport& outer = scene.viewport;
    const ViewBox shown_at{length("x", outer.width, 0), length("y", outer.height, 0),
                           size("width", outer.width), size("height", outer.height)};
    if (!(shown_at.width > 0) || !(shown_at.height > 0)) return;
    ViewBox box{0, 0, shown_at.width, shown_at.height};
    at(element, [&] {
      if (const auto text = trimmed(element.attribute("viewBox")); !text.empty()) {
        box = parse_view_box(text);
      }
    });
    const Eigen::Affine2d outside = scene.transform;
    scene.transform =
        outside * view_box_transform(box, shown_at, element.attribute("preserveAspectRatio"));
    scene.viewport = {box.width, box.height};
    const std::size_t first = file_.drawing.layers.size();
    draw_children(element, scene);
    warn_of_clipping(first, outside, shown_at);
  }

  /// Warns of the layers from `first` on, where they leave the box that a viewport shows.
  void warn_of_clipping(std::size_t first, const Eigen::Affine2d& transform, const ViewBox& box) {
    const Eigen::Vector2d corner(box.x, box.y), size(box.width, box.height);
    const Eigen::Vector2d margin = 1e-9 * size;
    const Eigen::AlignedBox2d shown_box(corner - margin, corner + size + margin);
    const Eigen::Affine2d back = transform.inverse();
    for (std::size_t i = first; i < file_.drawing.layers.size(); ++i) {
      for (const Subpath& subpath : file_.drawing.layers[i].subpaths) {
        for (const BezierSegment& segment : subpath.segments) {
          if (shown_box.contains(back * Eigen::Vector2d(segment.control.col(0)))) continue;
          return warnings_.add("what leaves a nested svg or symbol is not clipped");
        }
      }
    }
  }

  void draw_shape(const XmlElement& shape, const Scene& scene) {
    const int number = ++shapes_of_name_[shape.name];
    std::string id(scene.use_id.empty() ? shape.attribute("id") : scene.use_id);
    const bool named = !id.empty();
    if (!named) id = fmt::format("{}-{}", shape.name, number);
    const double scale = std::sqrt(std::abs(scene.transform.linear().determinant()));
    Layer layer{id, {}, paint_of(scene.style, scale)};
    if (!scene.style.visible || (!layer.paint.fill && !layer.paint.stroke)) {
      nothing_drawn_ =
          fmt::format("line {}: {} has neither fill nor stroke", shape.line, shown(id));
      return;
    }
    for (const auto& child : shape.children) {
      if (!is_never_drawn(child->name)) warn_of_element(*child);
    }
    at(shape, [&] {
      layer.subpaths = outline_of(shape, scene.viewport);
      transform_outline(layer.subpaths, scene.transform);
    });
    if (layer.paint.stroke && layer.paint.line_cap != LineCap::butt) lengthen_dots(layer);
    std::erase_if(layer.subpaths, has_no_length);
    if (layer.subpaths.empty()) {
      nothing_drawn_ = fmt::format("line {}: {} has no length", shape.line, shown(id));
      warnings_.add("line {}: {} has no length", shape.line, shown(id));
      return;
    }
    warn_of_uneven_stroke(layer.paint, scene.transform);
    count_segments(shape, layer);
    add(shape, std::move(layer), named, scene.style.stroke_first);
  }

  /// Of a line without length the caps are painted, along the axis of x. So it is given one, too
  /// short to be seen.
  static void lengthen_dots(Layer& layer) {
    for (Subpath& subpath : layer.subpaths) {
      if (!has_no_length(subpath) || subpath.segments.empty()) continue;
      BezierSegment line;
      line.control.resize(2, 2);
      line.control.colwise() = subpath.segments.front().control.col(0).eval();
      line.control(0, 1) += 1e-4 * layer.paint.stroke_width;
      subpath = {{line}, false};
    }
  }

  void warn_of_uneven_stroke(const Paint& paint, const Eigen::Affine2d& transform) {
    const Eigen::Matrix2d square = transform.linear().transpose() * transform.linear();
    const double mean = square.trace() / 2;
    if (paint.stroke && (square - mean * Eigen::Matrix2d::Identity()).norm() > 1e-6 * mean) {
      warnings_.add("a stroke is scaled unevenly; its mean width is used");
    }
  }

  void count_segments(const XmlElement& shape, const Layer& layer) {
    for (const Subpath& subpath : layer.subpaths) segments_ += subpath.segments.size();
    if (segments_ > most_segments) {
      refuse(shape, fmt::format("more than {} segments are drawn", most_segments));
    }
    if (file_.drawing.layers.size() + 2 > most_layers) {
      refuse(shape, fmt::format("more than {} layers are drawn", most_layers));
    }
  }

  /// A fill closes its subpaths, a stroke does not: together they are two layers. So they are where
  /// the stroke is painted first.
  void add(const XmlElement& shape, Layer layer, bool named, bool stroke_first) {
    const auto is_open = [](const Subpath& subpath) { return !subpath.closed; };
    const bool open = std::any_of(layer.subpaths.begin(), layer.subpaths.end(), is_open);
    const bool has_both = layer.paint.fill && layer.paint.stroke;
    if (!layer.paint.fill || (!open && !(stroke_first && has_both))) {
      return append(std::move(layer), named);
    }
    Layer stroke = layer;
    stroke.paint.fill.reset();
    layer.paint.stroke.reset();
    std::erase_if(layer.subpaths, is_straight_line);
    for (Subpath& subpath : layer.subpaths) {
      if (subpath.closed) continue;
      BezierSegment closing;
      closing.control.resize(2, 2);
      closing.control << subpath.segments.back().control.rightCols<1>(),
          subpath.segments.front().control.leftCols<1>();
      subpath.segments.push_back(closing);
      subpath.closed = true;
    }
    const bool filled = !layer.subpaths.empty(), stroked = stroke.paint.stroke.has_value();
    if (!filled && !stroked) {
      nothing_drawn_ =
          fmt::format("line {}: {} is a line without stroke", shape.line, shown(layer.id));
      warnings_.add("line {}: {} is a line without stroke", shape.line, shown(layer.id));
      return;
    }
    if (filled && stroked) stroke.id += "-stroke";
    if (stroked && filled && stroke_first) {
      append(std::move(stroke), false);
      return append(std::move(layer), named);
    }
    if (filled) append(std::move(layer), named);
    if (stroked) append(std::move(stroke), named && !filled);
  }

  void append(Layer layer, bool named) {
    layer.id = unique_id(layer.id, named);
    file_.drawing.layers.push_back(std::move(layer));
  }

  /// A number is added to an id that is taken; what is made up is not one of the file either.
  std::string unique_id(const std::string& wanted, bool named) {
    if ((named || !elements_.contains(wanted)) && ids_.insert(wanted).second) return wanted;
    for (int& copies = copies_[wanted];;) {
      std::string id = fmt::format("{}-{}", wanted, ++copies + 1);
      if (!elements_.contains(id) && ids_.insert(id).second) return id;
    }
  }

  const XmlElement& root_;
  ElementIndex elements_;
  StyleSheet sheet_;
  Warnings warnings_;
  DrawingFile file_;
  std::string nothing_drawn_;  ///< why the last shape that is not painted is not
  std::map<std::string, int, std::less<>> shapes_of_name_, copies_;
  std::set<std::string> ids_;
  std::vector<const XmlElement*> used_;
  std::size_t segments_ = 0;
  int elements_drawn_ = 0, depth_ = 0;
};

}  // namespace

DrawingFile read_svg(std::string_view text) {
  const auto root = read_xml(text);
  return SvgReader(*root).read();
}

}  // namespace wavecurve::io
