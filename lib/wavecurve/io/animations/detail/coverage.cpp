#include "wavecurve/io/animations/detail/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"

namespace wavecurve::io {

namespace {

constexpr int lines = 16;  ///< scan lines a pixel

struct Edge {
  double top, bottom;  ///< ordinates, in scan lines
  double x, slope;     ///< abscissa at the top, and its change a scan line
  int winding;         ///< of the ray to the left that crosses it
};

struct Crossing {
  double x;
  int winding;
};

std::vector<Edge> edges_of(const std::vector<Contour>& polygons) {
  std::vector<Edge> edges;
  for (const Contour& polygon : polygons) {
    for (Eigen::Index i = 0, n = polygon.rows(); i < n; ++i) {
      const Eigen::Index next = i + 1 == n ? 0 : i + 1;
      double x = polygon(i, 0), y = lines * polygon(i, 1);
      double other_x = polygon(next, 0), other_y = lines * polygon(next, 1);
      if (y == other_y) continue;
      const int winding = y < other_y ? 1 : -1;
      if (winding < 0) {
        std::swap(x, other_x);
        std::swap(y, other_y);
      }
      edges.push_back({y, other_y, x, (other_x - x) / (other_y - y), winding});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.top < b.top; });
  return edges;
}

bool is_inside(int winding, FillRule rule) {
  return rule == FillRule::evenodd ? winding % 2 != 0 : winding != 0;
}

Contour disc(double x, double y, double radius) {
  // The chord of a side stays within a twentieth of a pixel of the circle.
  const double half_side = arccosine(1 - std::min(0.05 / radius, 0.5));
  const auto sides =
      static_cast<Eigen::Index>(std::max(8.0, std::ceil(std::numbers::pi / half_side)));
  Contour polygon(sides, 2);
  for (Eigen::Index i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
    polygon.row(i) << x + radius * cosine(angle), y + radius * sine(angle);
  }
  return polygon;
}

/// A contour without steps of no length.
Contour without_repetitions(const Contour& contour) {
  Contour result(contour.rows(), 2);
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < contour.rows(); ++i) {
    if (count == 0 || contour.row(i) != result.row(count - 1)) result.row(count++) = contour.row(i);
  }
  while (count > 1 && result.row(count - 1) == result.row(0)) --count;
  return result.topRows(count);
}

void append_stroke(std::vector<Contour>& pieces, const Contour& polygon, double radius) {
  const Eigen::Index n = polygon.rows();
  if (n == 1) pieces.push_back(disc(polygon(0, 0), polygon(0, 1), radius));
  for (Eigen::Index i = 0; i < n && n > 1; ++i) {
    const Eigen::RowVector2d before = polygon.row((i + n - 1) % n), here = polygon.row(i),
                             after = polygon.row((i + 1) % n);
    const Eigen::RowVector2d step = after - here, last_step = here - before;
    const Eigen::RowVector2d offset =
        radius / step.norm() * Eigen::RowVector2d(step.y(), -step.x());
    // All pieces turn the same way, so that they add up under the nonzero rule.
    Contour quad(4, 2);
    quad << here + offset, after + offset, after - offset, here - offset;
    pieces.push_back(quad);
    const double cross = last_step.x() * step.y() - last_step.y() * step.x();
    const double turn = arctangent(cross, last_step.dot(step));
    const Eigen::RowVector2d last_offset =
        radius / last_step.norm() * Eigen::RowVector2d(last_step.y(), -last_step.x());
    Contour wedge(3, 2);  // between the rectangles, on the outer side of the turn
    if (cross > 0) {
      wedge << here, here + last_offset, here + offset;
    } else {
      wedge << here, here - offset, here - last_offset;
    }
    pieces.push_back(wedge);
    // What a chord leaves of the round join, in pixels.
    if (radius * turn * turn / 8 > 0.02) pieces.push_back(disc(here.x(), here.y(), radius));
  }
}

}  // namespace

Coverage::Coverage(int width, int height)
    : width_(width),
      height_(height),
      shares_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0F) {}

void Coverage::add_span(int y, double from, double to) {
  from = std::clamp(from, 0.0, static_cast<double>(width_));
  to = std::clamp(to, 0.0, static_cast<double>(width_));
  if (!(to > from)) return;
  float* shares = shares_.data() + static_cast<std::ptrdiff_t>(y) * width_;
  const int first = static_cast<int>(from), last = static_cast<int>(to);
  constexpr float line = 1.0F / lines;
  if (first == last) {
    shares[first] += static_cast<float>(to - from) * line;
    return;
  }
  shares[first] += static_cast<float>(first + 1 - from) * line;
  for (int x = first + 1; x < last; ++x) shares[x] += line;
  if (last < width_) shares[last] += static_cast<float>(to - last) * line;
}

void Coverage::fill(const std::vector<Contour>& polygons, FillRule rule) {
  const std::vector<Edge> edges = edges_of(polygons);
  if (edges.empty()) return;
  double bottom = 0;
  for (const Edge& edge : edges) bottom = std::max(bottom, edge.bottom);
  const auto row_at = [&](double y) {
    return static_cast<int>(std::clamp(y / lines, 0.0, static_cast<double>(height_)));
  };
  first_row_ = row_at(edges.front().top);
  end_row_ = std::min(row_at(bottom) + 1, height_);
  std::vector<Edge> active;
  std::vector<Crossing> crossings;
  auto next = edges.begin();
  for (int line = first_row_ * lines; line < end_row_ * lines; ++line) {
    const double y = line + 0.5;
    for (; next != edges.end() && next->top <= y; ++next) active.push_back(*next);
    std::erase_if(active, [&](const Edge& edge) { return edge.bottom <= y; });
    crossings.clear();
    for (const Edge& edge : active) {
      crossings.push_back({edge.x + (y - edge.top) * edge.slope, edge.winding});
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      winding += crossings[i].winding;
      if (is_inside(winding, rule)) add_span(line / lines, crossings[i].x, crossings[i + 1].x);
    }
  }
}

std::vector<Contour> stroke_polygons(const std::vector<Contour>& polygons, double radius) {
  std::vector<Contour> pieces;
  for (const Contour& polygon : polygons)
    append_stroke(pieces, without_repetitions(polygon), radius);
  return pieces;
}

}  // namespace wavecurve::io
