#include "wavecurve/io/drawings/detail/svg/svg_clip.hpp"

#include <algorithm>
#include <stdexcept>

#include <Eigen/Geometry>

#include "wavecurve/io/drawings/detail/svg/svg_shape.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_transform.hpp"
#include "wavecurve/io/drawings/detail/svg/tidy_outline.hpp"

namespace wavecurve::io {

namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr std::size_t most_corners = 100, most_clip_shapes = 10;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Whether all points are at least so far on the inner side of every edge of a polygon that is clockwise as seen.
template <typename Range>
bool are_inside(const Points& polygon, const Range& points, double distance) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    const double length = edge.norm();
    for (const Eigen::Vector2d& point : points) {
      if (cross(edge, point - polygon[i]) < distance * length) return false;
    }
  }
  return true;
}

double doubled_area(const Points& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return sum;
}

/// The control points of a closed subpath, or only the ends of its segments.
Points points_of(const Subpath& subpath, bool ends_only) {
  Points points;
  for (const BezierSegment& segment : subpath.segments) {
    const Eigen::Index count = ends_only ? 1 : segment.control.cols() - 1;
    for (Eigen::Index i = 0; i < count; ++i) points.emplace_back(segment.control.col(i));
  }
  return points;
}

}  // namespace

std::vector<std::vector<Subpath>> clip_shapes(std::string_view id, const Eigen::Affine2d& transform,
                                              const Viewport& viewport, const StyleSource& source) {
  std::vector<std::vector<Subpath>> shapes;
  const auto found = source.elements.find(id);
  if (found == source.elements.end() || found->second->name != "clipPath") return shapes;
  const XmlElement& clip = *found->second;
  if (clip.attribute("clipPathUnits") == "objectBoundingBox") return shapes;
  for (const auto& child : clip.children) {
    if (!is_shape(*child) || shapes.size() == most_clip_shapes) continue;
    const Style style = style_of(*child, {}, viewport, source);
    auto subpaths = outline_of(*child, style.own, viewport).subpaths;
    try {
      transform_outline(subpaths, transform * transform_of(clip, {}, viewport) *
                                      transform_of(*child, style.own, viewport));
    } catch (const std::invalid_argument&) {
      continue;  // a shape that is broken shows nothing
    }
    std::erase_if(subpaths, has_no_length);
    shapes.push_back(std::move(subpaths));
  }
  return shapes;
}

bool is_within(const Layer& layer, const std::vector<Subpath>& clip) {
  if (clip.size() != 1 || clip[0].segments.size() > most_corners) return false;
  // A curve whose control polygon is convex is so itself, and holds the polygon of its ends.
  Points corners = points_of(clip[0], false), ends = points_of(clip[0], true);
  if (doubled_area(corners) < 0) {
    std::reverse(corners.begin(), corners.end());
    std::reverse(ends.begin(), ends.end());
  }
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : corners) box.extend(corner);
  const double rounding = 1e-9 * box.diagonal().norm();
  if (ends.size() < 3 || !are_inside(corners, corners, -rounding)) return false;
  const double margin = layer.paint.stroke ? layer.paint.stroke_width / 2 : 0;
  return std::all_of(layer.subpaths.begin(), layer.subpaths.end(), [&](const Subpath& subpath) {
    Points points = points_of(subpath, false);
    points.emplace_back(subpath.segments.back().control.rightCols<1>());
    return are_inside(ends, points, margin - rounding);
  });
}

}  // namespace wavecurve::io
