#include "wavecurve/io/drawings/detail/svg/read_svg.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/io/drawings/detail/svg/fit_view_box.hpp"
#include "wavecurve/io/drawings/detail/svg/layer_names.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_clip.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_element.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_shape.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_style.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_transform.hpp"
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

class SvgReader {
 public:
  explicit SvgReader(const XmlElement& root) : root_(root) { index(root); }

  DrawingFile read(std::string_view id) {
    if (root_.name != "svg") {
      throw std::invalid_argument(
          fmt::format("line {}: the root element is {}, not svg", root_.line, root_.name));
    }
    if (id.empty()) {
      Scene scene;
      file_.drawing.view_box = view_box_of(root_);
      if (file_.drawing.view_box.width == 0 && has_percentages(root_)) assume_window();
      scene.viewport = {file_.drawing.view_box.width, file_.drawing.view_box.height};
      draw(root_, scene);
    } else {
      draw_alone(id);
    }
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
    if (element.name == "symbol" && nothing_drawn_.empty()) {
      nothing_drawn_ = fmt::format("symbols only; FILE#{} is one", shown(element.attribute("id")));
    }
    for (const auto& child : element.children) index(*child);
  }

  /// By the attribute, else by width and height in lengths; of no size where neither says any.
  ViewBox view_box_of(const XmlElement& element) {
    ViewBox box;
    if (const auto text = trimmed(element.attribute("viewBox")); !text.empty()) {
      if (tolerate(element, "it is left out", [&] { box = parse_view_box(text); })) return box;
    }
    return box_of_lengths(element.attribute("width"), element.attribute("height"));
  }

  /// What viewers take for the size of a window that nobody says (CSS 2, 10.3.2).
  void assume_window() {
    file_.drawing.view_box = {0, 0, 300, 150};
    warnings_.add("the drawing has no size; percentages are taken of 300 by 150");
  }

  void warn(const XmlElement& element, std::string_view defect, std::string_view remedy) {
    nothing_drawn_ = fmt::format("line {}: {}: {}", element.line, name_of(element), defect);
    warnings_.add("line {}: {}: {}; {}", element.line, name_of(element), defect, remedy);
  }

  /// Whether an action succeeds; if not, it is said what becomes of it.
  template <typename Action>
  bool tolerate(const XmlElement& element, std::string_view remedy, const Action& action) {
    try {
      action();
      return true;
    } catch (const std::invalid_argument& error) {
      warn(element, error.what(), remedy);
      return false;
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
    if (scene.style.displayed && meets_conditions(element)) {
      tolerate(element, "it is left out", [&] {
        scene.transform = scene.transform * transform_of(element, scene.style.own, scene.viewport);
      });
      const std::size_t first = file_.drawing.layers.size();
      draw_kind(element, scene);
      if (scene.style.opacity < outer_opacity && !is_shape(element) &&
          file_.drawing.layers.size() > first + 1) {
        warnings_.add("the opacity of a group is given to each of its shapes");
      }
      clip(scene, first);
    }
    --depth_;
  }

  /// The layers from `first` on, by the property clip-path.
  void clip(const Scene& scene, std::size_t first) {
    const auto property = scene.style.own.find("clip-path");
    if (property == scene.style.own.end() || property->second == "none") return;
    const StyleSource source{sheet_, elements_, warnings_};
    try {
      const Clipping::Place place{scene.transform, scene.viewport,
                                  std::span(file_.drawing.layers).subspan(first)};
      cut(first, clipping_.region(property->second, place, source));
    } catch (const std::invalid_argument& error) {
      warnings_.add("the clip-path '{}' clips nothing: {}", shown(property->second), error.what());
    }
  }

  /// Leaves of the layers from `first` on what lies within a region.
  void cut(std::size_t first, const Region& region) {
    auto& layers = file_.drawing.layers;
    std::vector<Layer> remaining;
    for (std::size_t i = first; i < layers.size(); ++i) {
      auto parts = clipping_.clipped(layers[i], region);
      if (parts.empty()) nothing_drawn_ = shown(layers[i].id) + " lies outside of its clip path";
      if (parts.size() == 2) parts[1].id = names_.unique({layers[i].id + "-stroke", false});
      std::ranges::move(parts, std::back_inserter(remaining));
    }
    layers.resize(first);
    std::ranges::move(remaining, std::back_inserter(layers));
  }

  void draw_kind(const XmlElement& element, const Scene& scene) {
    if (is_shape(element)) {
      draw_shape(element, scene);
    } else if (element.name == "use") {
      draw_use(element, scene);
    } else if (element.name == "svg" && &element != &root_) {
      draw_nested(element, scene, nullptr);
    } else if (element.name == "switch") {
      draw_switch(element, scene);
    } else if (element.name == "svg" || element.name == "g" || element.name == "a") {
      draw_children(element, scene);
    } else if (!is_never_drawn(element.name)) {
      warn_of_element(element);
    }
  }

  void warn_of_element(const XmlElement& element) {
    std::string said = fmt::format("the element {} is not supported", shown(element.name));
    if (element.name == "text") said = "text is not supported: convert it to paths";
    if (element.name == "image") said = "images are not supported";
    if (element.name == "text" || element.name == "image") nothing_drawn_ = said;
    warnings_.add("{}", said);
  }

  void draw_children(const XmlElement& element, Scene scene) {
    scene.use_id = {};
    for (const auto& child : element.children) {
      if (!is_never_drawn(child->name)) draw(*child, scene);
    }
  }

  /// The first child that a viewer like this one draws.
  void draw_switch(const XmlElement& element, Scene scene) {
    scene.use_id = {};
    for (const auto& child : element.children) {
      if (is_never_drawn(child->name) || child->name == "foreignObject") continue;
      if (meets_conditions(*child)) return draw(*child, scene);
    }
  }

  /// One element as a <use> in another file would draw it; of a symbol or view its view box is that of
  /// the drawing.
  void draw_alone(std::string_view id) {
    const auto found = elements_.find(id);
    if (found == elements_.end()) {
      throw std::invalid_argument(fmt::format("no element has the id '{}'", shown(id)));
    }
    const XmlElement& element = *found->second;
    Scene scene;
    const bool is_view = element.name == "view", is_symbol = element.name == "symbol";
    const ViewBox of_root = view_box_of(root_);
    if (is_view || is_symbol || element.name == "svg")
      file_.drawing.view_box = view_box_of(element);
    const ViewBox& box = file_.drawing.view_box.width > 0 ? file_.drawing.view_box : of_root;
    scene.viewport = {box.width, box.height};
    if (is_view) return draw(root_, scene);
    if (element.name == "svg" || is_symbol) {
      const StyleSource source{sheet_, elements_, warnings_};
      scene.style = style_of(element, scene.style, scene.viewport, source);
      return draw_children(element, scene);
    }
    draw(element, scene);
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
      return warn(use, fmt::format("uses '{}' within itself", shown(reference)), "it is skipped");
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
    if (const auto text = trimmed(element.attribute("viewBox")); !text.empty()) {
      tolerate(element, "it is left out", [&] { box = parse_view_box(text); });
    }
    const Eigen::Affine2d outside = scene.transform;
    scene.transform =
        outside * view_box_transform(box, shown_at, element.attribute("preserveAspectRatio"));
    scene.viewport = {box.width, box.height};
    const std::size_t first = file_.drawing.layers.size();
    draw_children(element, scene);
    clip_to(shown_at, outside, element, first);
  }

  /// The layers from `first` on, to what a viewport shows.
  void clip_to(const ViewBox& box, const Eigen::Affine2d& transform, const XmlElement& element,
               std::size_t first) {
    if (sheet_.cascade(element)["overflow"] == "visible") return;
    try {
      cut(first, region_of(box, transform));
    } catch (const std::invalid_argument& error) {
      warnings_.add("what leaves a nested svg or symbol is not clipped: {}", error.what());
    }
  }

  void draw_shape(const XmlElement& shape, const Scene& scene) {
    const LayerNames::Name name = names_.name_of(shape, scene.use_id, !used_.empty());
    const double scale = std::sqrt(std::abs(scene.transform.linear().determinant()));
    Layer layer{name.text, {}, paint_of(scene.style, scale)};
    if (!scene.style.visible || (!layer.paint.fill && !layer.paint.stroke)) {
      nothing_drawn_ =
          fmt::format("line {}: {} has neither fill nor stroke", shape.line, shown(name.text));
      return;
    }
    for (const auto& child : shape.children) {
      if (!is_never_drawn(child->name)) warn_of_element(*child);
    }
    ShapeOutline outline = outline_of(shape, scene.style.own, scene.viewport);
    layer.subpaths = std::move(outline.subpaths);
    const bool within_bounds = tolerate(
        shape, "it is skipped", [&] { transform_outline(layer.subpaths, scene.transform); });
    if (!within_bounds) return;
    if (layer.paint.stroke && layer.paint.line_cap != LineCap::butt) {
      lengthen_dots(layer.subpaths, 1e-4 * layer.paint.stroke_width);
    }
    std::erase_if(layer.subpaths, has_no_length);
    if (!outline.defect.empty()) {
      warn(shape, outline.defect,
           layer.subpaths.empty() ? "it is skipped" : "what is sound of it is drawn");
    } else if (layer.subpaths.empty()) {
      nothing_drawn_ = fmt::format("line {}: {} has no length", shape.line, shown(name.text));
      warnings_.add("line {}: {} has no length", shape.line, shown(name.text));
    }
    if (layer.subpaths.empty()) return;
    warn_of_uneven_stroke(layer.paint, scene.transform);
    count_segments(shape, layer);
    add(shape, std::move(layer), name, scene.style.stroke_first);
  }

  void warn_of_uneven_stroke(const Paint& paint, const Eigen::Affine2d& transform) {
    if (!paint.stroke || scales_evenly(transform)) return;
    warnings_.add("a stroke is scaled unevenly; its mean width is used");
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
  void add(const XmlElement& shape, Layer layer, const LayerNames::Name& name, bool stroke_first) {
    const bool open = !std::ranges::all_of(layer.subpaths, &Subpath::closed);
    const bool is_reversed = stroke_first && layer.paint.stroke;
    if (!layer.paint.fill || !(open || is_reversed)) return append(std::move(layer), name);
    Layer stroke = layer;
    stroke.paint.fill.reset();
    layer.paint.stroke.reset();
    close_areas(layer.subpaths);
    const bool filled = !layer.subpaths.empty(), stroked = stroke.paint.stroke.has_value();
    if (!filled && !stroked) {
      nothing_drawn_ =
          fmt::format("line {}: {} is a line without stroke", shape.line, shown(layer.id));
      warnings_.add("line {}: {} is a line without stroke", shape.line, shown(layer.id));
      return;
    }
    if (!filled) return append(std::move(stroke), name);
    if (!stroked) return append(std::move(layer), name);
    const LayerNames::Name stroke_name{name.text + "-stroke", false};
    if (stroke_first) append(std::move(stroke), stroke_name);
    append(std::move(layer), name);
    if (!stroke_first) append(std::move(stroke), stroke_name);
  }

  void append(Layer layer, const LayerNames::Name& name) {
    layer.id = names_.unique(name);
    file_.drawing.layers.push_back(std::move(layer));
  }

  const XmlElement& root_;
  ElementIndex elements_;
  StyleSheet sheet_;
  Warnings warnings_;
  DrawingFile file_;
  std::string nothing_drawn_;  ///< why the last shape that is not painted is not
  LayerNames names_{elements_};
  Clipping clipping_;
  std::vector<const XmlElement*> used_;
  std::size_t segments_ = 0;
  int elements_drawn_ = 0, depth_ = 0;
};

}  // namespace

DrawingFile read_svg(std::string_view text, std::string_view id) {
  const auto root = read_xml(text);
  return SvgReader(*root).read(id);
}

}  // namespace wavecurve::io
