#include "wavecurve/io/drawings/detail/svg/svg_clip.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/io/drawings/detail/stroke_polygons.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_shape.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_transform.hpp"
#include "wavecurve/io/drawings/detail/svg/tidy_outline.hpp"
#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

constexpr std::size_t most_steps = 20'000'000;

/// How far polygons may be from curves, as a share of the size of what is clipped: an eighth of a pixel of a picture of
/// 1024. A share of an area as small is not missed.
constexpr double clip_tolerance = 1.0 / 8192;

Eigen::AlignedBox2d box_of(const std::vector<Subpath>& subpaths) {
  Eigen::AlignedBox2d box;
  for (const Subpath& subpath : subpaths) {
    for (const BezierSegment& segment : subpath.segments) {
      for (const auto& point : segment.control.colwise()) box.extend(Eigen::Vector2d(point));
    }
  }
  return box;
}

Eigen::AlignedBox2d box_of(const Region& region) {
  Eigen::AlignedBox2d box;
  for (const Contour& polygon : region.polygons) {
    for (const auto& point : polygon.rowwise()) box.extend(Eigen::Vector2d(point.transpose()));
  }
  return box;
}

/// A value of a property; of the outer element where it is not given.
std::string_view inherited(const Properties& own, const Properties& outer,
                           std::string_view property) {
  for (const Properties* properties : {&own, &outer}) {
    const auto found = properties->find(property);
    if (found != properties->end() && found->second != "inherit") return found->second;
  }
  return {};
}

double cross(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Whether a point is at least so far on the inner side of every edge of a convex polygon that turns clockwise as seen.
bool is_inside(const Contour& polygon, const Eigen::RowVector2d& point, double distance) {
  for (Eigen::Index i = 0, n = polygon.rows(); i < n; ++i) {
    const Eigen::RowVector2d edge = polygon.row(i + 1 == n ? 0 : i + 1) - polygon.row(i);
    if (cross(edge, point - polygon.row(i)) < distance * edge.norm()) return false;
  }
  return true;
}

/// The stroke of a layer, as polygons for the nonzero rule, as fine as a picture needs that shows so much.
std::vector<Contour> stroke_of(const Layer& layer, const std::vector<Contour>& lines, double size) {
  // Where pixels are this small, what the polygons leave away is within the tolerance.
  const double scale = 512 / std::max(size, layer.paint.stroke_width);
  std::vector<Contour> scaled;
  std::vector<bool> open;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    scaled.emplace_back(scale * lines[i]);
    open.push_back(!layer.subpaths[i].closed);
  }
  const Paint& paint = layer.paint;
  auto polygons = stroke_polygons(
      scaled, open,
      {scale * paint.stroke_width / 2, paint.line_cap, paint.line_join, paint.miter_limit});
  for (Contour& polygon : polygons) polygon /= scale;
  return polygons;
}

std::size_t count_of(const std::vector<Contour>& polygons) {
  std::size_t count = 0;
  for (const Contour& polygon : polygons) count += static_cast<std::size_t>(polygon.rows());
  return count;
}

Layer with_outline(Layer layer, const Region& region) {
  layer.subpaths = outline_of(region);
  std::erase_if(layer.subpaths, has_no_length);
  return layer;
}

/// A layer that is filled as another is stroked.
Layer as_fill(Layer layer) {
  Paint& paint = layer.paint;
  paint.fill = paint.stroke;
  paint.fill_opacity = paint.stroke_opacity;
  paint.fill_rule = FillRule::nonzero;
  paint.stroke.reset();
  return layer;
}

}  // namespace

Region region_of(const ViewBox& box, const Eigen::Affine2d& transform) {
  Eigen::Matrix<double, 2, 4> corners;
  corners << box.x, box.x + box.width, box.x + box.width, box.x, box.y, box.y, box.y + box.height,
      box.y + box.height;
  return {{Contour((transform * corners).transpose())}};
}

/// As fine as a picture of this size needs.
std::vector<Contour> Clipping::polygons(const std::vector<Subpath>& subpaths, double size) {
  constexpr std::size_t steps_a_segment = 100;
  for (const Subpath& subpath : subpaths) take_steps(steps_a_segment * subpath.segments.size());
  return polygons_of(subpaths, std::max(clip_tolerance * size, 1e-300));
}

/// The box of what layers draw, without their strokes, in the coordinates of the place.
Eigen::AlignedBox2d Clipping::box_of_layers(const Place& place) {
  Eigen::AlignedBox2d box;
  if (place.transform.linear().determinant() == 0) return box;
  const Eigen::Affine2d back = place.transform.inverse();
  for (const Layer& layer : place.layers) {
    for (const Contour& polygon :
         polygons(layer.subpaths, box_of(layer.subpaths).diagonal().norm())) {
      for (const auto& point : polygon.rowwise()) {
        box.extend(back * Eigen::Vector2d(point.transpose()));
      }
    }
  }
  return box;
}

void Clipping::take_steps(std::size_t count) {
  steps_ += std::min(count, most_steps);
  if (steps_ > most_steps) throw std::invalid_argument("that would take too long");
}

void Clipping::take_steps(const std::vector<Contour>& polygons, const Region& region) {
  std::vector<Contour> all = polygons;
  all.insert(all.end(), region.polygons.begin(), region.polygons.end());
  take_steps(most_crossings(all));
}

Region Clipping::region(std::string_view value, const Place& place, const StyleSource& source) {
  if (!value.starts_with("url(")) throw std::invalid_argument("only url(#...) is supported");
  const std::string id = referred_id(value);
  const auto found = source.elements.find(id);
  if (found == source.elements.end() || found->second->name != "clipPath") {
    throw std::invalid_argument(fmt::format("no clipPath has the id '{}'", shown(id)));
  }
  const XmlElement& clip = *found->second;
  if (std::ranges::find(used_, &clip) != used_.end()) {
    throw std::invalid_argument("it is used within itself");
  }
  used_.push_back(&clip);
  Region region;
  try {
    region = region_of_element(clip, place, source);
  } catch (...) {
    used_.pop_back();
    throw;
  }
  used_.pop_back();
  return region;
}

Region Clipping::region_of_element(const XmlElement& clip, const Place& place,
                                   const StyleSource& source) {
  const Properties properties = style_of(clip, {}, place.viewport, source).own;
  Place inner = place;
  inner.transform = place.transform * transform_of(clip, properties, place.viewport);
  if (clip.attribute("clipPathUnits") == "objectBoundingBox") {
    const Eigen::AlignedBox2d box = box_of_layers(place);
    if (box.isEmpty()) return {};
    inner.transform =
        inner.transform * Eigen::Translation2d(box.min()) * Eigen::Scaling(box.sizes());
    inner.viewport = {1, 1};
  }
  Region region;
  for (const auto& child : clip.children) {
    if (child->name == "text") throw std::invalid_argument("text in it is not supported");
    if (is_shape(*child) || child->name == "use") {
      const Region shape = region_of_shape(*child, properties, inner, source);
      take_steps(shape.polygons, region);
      region = united(region, shape);
    }
  }
  return within_its_own(std::move(region), properties, place, source);
}

Region Clipping::region_of_shape(const XmlElement& shape, const Properties& outer,
                                 const Place& place, const StyleSource& source) {
  const Style style = style_of(shape, {}, place.viewport, source);
  if (!style.displayed || !style.visible) return {};
  Place inner = place;
  inner.transform = place.transform * transform_of(shape, style.own, place.viewport);
  if (shape.name == "use") {
    const std::string_view reference = shape.attribute("href");
    const auto found =
        source.elements.find(reference.substr(std::min<std::size_t>(1, reference.size())));
    if (found == source.elements.end() || !is_shape(*found->second)) return {};
    inner.transform.translate(
        Eigen::Vector2d(parse_length(shape.attribute("x"), place.viewport.width).value_or(0),
                        parse_length(shape.attribute("y"), place.viewport.height).value_or(0)));
    return within_its_own(region_of_shape(*found->second, outer, inner, source), style.own, inner,
                          source);
  }
  auto subpaths = outline_of(shape, style.own, place.viewport).subpaths;
  transform_outline(subpaths, inner.transform);
  const auto outlines = polygons(subpaths, box_of(subpaths).diagonal().norm());
  take_steps(outlines, {});
  const bool is_evenodd = inherited(style.own, outer, "clip-rule") == "evenodd";
  return within_its_own(region_of(outlines, is_evenodd ? FillRule::evenodd : FillRule::nonzero),
                        style.own, inner, source);
}

Region Clipping::within_its_own(Region region, const Properties& properties, const Place& place,
                                const StyleSource& source) {
  const auto property = properties.find("clip-path");
  if (property == properties.end() || property->second == "none") return region;
  const Region other = this->region(property->second, place, source);
  take_steps(region.polygons, other);
  return intersected(region, other);
}

bool Clipping::is_within(const Layer& layer, const Region& region) {
  if (region.polygons.size() != 1) return false;
  Contour polygon = region.polygons.front();
  if (polygon.rows() < 3) return false;
  take_steps(static_cast<std::size_t>(polygon.rows() * polygon.rows()));
  double doubled = 0;
  for (Eigen::Index i = 0, n = polygon.rows(); i < n; ++i) {
    doubled += cross(polygon.row(i), polygon.row(i + 1 == n ? 0 : i + 1));
  }
  if (doubled < 0) polygon = polygon.colwise().reverse().eval();
  const double rounding = 1e-9 * box_of(region).diagonal().norm();
  const auto holds = [&](const Eigen::RowVector2d& point, double distance) {
    return is_inside(polygon, point, distance);
  };
  for (const auto& corner : polygon.rowwise()) {
    if (!holds(corner, -rounding)) return false;  // it is not convex
  }
  const double margin = layer.paint.stroke ? layer.paint.stroke_width / 2 : 0;
  for (const Subpath& subpath : layer.subpaths) {
    take_steps(4 * subpath.segments.size() * static_cast<std::size_t>(polygon.rows()));
    for (const BezierSegment& segment : subpath.segments) {
      for (const auto& point : segment.control.colwise()) {
        if (!holds(point.transpose(), margin - rounding)) return false;
      }
    }
  }
  return true;
}

std::vector<Layer> Clipping::clipped(const Layer& layer, const Region& region) {
  if (is_within(layer, region)) return {layer};
  const double size =
      std::min(box_of(region).diagonal().norm(), box_of(layer.subpaths).diagonal().norm());
  const auto outlines = polygons(layer.subpaths, size);
  // What remains of an area, or none where that is all of it.
  const auto cut = [&](const std::vector<Contour>& area, FillRule rule) {
    take_steps(area, region);
    const Region whole = region_of(area, rule);
    take_steps(whole.polygons, region);
    Region part = intersected(whole, region);
    const bool is_whole = part.area() >= (1 - clip_tolerance) * whole.area();
    return std::pair(is_whole, std::move(part));
  };
  Layer fill = layer, stroke = layer;
  fill.paint.stroke.reset();
  stroke.paint.fill.reset();
  bool fill_stays = true, stroke_stays = true;
  if (layer.paint.fill) {
    const auto [stays, part] = cut(outlines, layer.paint.fill_rule);
    fill_stays = stays;
    if (!stays) fill = with_outline(fill, part);
  }
  if (layer.paint.stroke) {
    constexpr std::size_t most_corners_a_join = 1000;
    take_steps(most_corners_a_join * count_of(outlines));
    const auto [stays, part] = cut(stroke_of(layer, outlines, size), FillRule::nonzero);
    stroke_stays = stays;
    if (!stays) stroke = with_outline(as_fill(stroke), part);
  }
  if (fill_stays && stroke_stays) return {layer};
  std::vector<Layer> parts;
  if (layer.paint.fill && !fill.subpaths.empty()) parts.push_back(std::move(fill));
  if (layer.paint.stroke && !stroke.subpaths.empty()) parts.push_back(std::move(stroke));
  return parts;
}

}  // namespace wavecurve::io
