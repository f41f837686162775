#include "wavecurve/io/animations/detail/coverage.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

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
  first_column_ = std::min(first_column_, first);
  end_column_ = std::max(end_column_, std::min(last + 1, width_));
  constexpr float line = 1.0F / lines;
  if (first == last) {
    shares[first] += static_cast<float>(to - from) * line;
    return;
  }
  shares[first] += static_cast<float>(first + 1 - from) * line;
  for (int x = first + 1; x < last; ++x) shares[x] += line;
  if (last < width_) shares[last] += static_cast<float>(to - last) * line;
}

/// Only what was covered: a drawing has hundreds of layers, most of them small.
void Coverage::clear() {
  for (int y = first_row_; y < end_row_ && first_column_ < end_column_; ++y) {
    float* shares = shares_.data() + static_cast<std::ptrdiff_t>(y) * width_;
    std::fill(shares + first_column_, shares + end_column_, 0.0F);
  }
  first_row_ = end_row_ = end_column_ = 0;
  first_column_ = width_;
}

void Coverage::fill(const std::vector<Contour>& polygons, FillRule rule) {
  clear();
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

}  // namespace wavecurve::io
