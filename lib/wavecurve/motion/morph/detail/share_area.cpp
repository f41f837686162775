#include "wavecurve/motion/morph/detail/share_area.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

namespace wavecurve::motion {

namespace {

constexpr int lines = 64;

/// Where an edge of layer 0 or 1 crosses a line.
struct Crossing {
  double x;
  std::size_t layer;
  int winding;
};
using Crossings = std::array<std::vector<Crossing>, lines>;

Eigen::AlignedBox2d box_of(const FrameLayer& layer) {
  Eigen::AlignedBox2d box;
  for (const Contour& contour : layer.contours) {
    for (const auto& point : contour.rowwise()) box.extend(Eigen::Vector2d(point.transpose()));
  }
  return box;
}

void add_edge(Crossings& crossings, std::size_t layer, const Eigen::AlignedBox2d& box,
              const Eigen::RowVector2d& from, const Eigen::RowVector2d& to) {
  const auto [low, high] = std::minmax(from.y(), to.y());
  const double step = box.sizes().y() / lines;
  const double first = std::clamp((low - box.min().y()) / step - 1, 0.0, 1.0 * lines);
  for (int i = static_cast<int>(first); i < lines; ++i) {
    const double y = box.min().y() + (i + 0.5) * step;
    if (y >= high) return;
    if (y < low) continue;
    const double x = from.x() + (y - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
    crossings[static_cast<std::size_t>(i)].push_back({x, layer, to.y() > from.y() ? 1 : -1});
  }
}

bool is_inside(int winding, FillRule rule) {
  return rule == FillRule::evenodd ? winding % 2 != 0 : winding != 0;
}

}  // namespace

bool share_area(const FrameLayer& a, const FrameLayer& b) {
  const std::array<const FrameLayer*, 2> layers{&a, &b};
  const Eigen::AlignedBox2d box = box_of(a).intersection(box_of(b));
  if (box.isEmpty() || !(box.sizes().minCoeff() > 0)) return false;
  Crossings crossings;
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    for (const Contour& contour : layers[layer]->contours) {
      for (Eigen::Index i = 0, n = contour.rows(); i < n; ++i) {
        add_edge(crossings, layer, box, contour.row(i), contour.row(i + 1 == n ? 0 : i + 1));
      }
    }
  }
  const double least = 1e-9 * box.sizes().x();  // coordinates are rounded
  for (auto& line : crossings) {
    std::ranges::sort(line, {}, &Crossing::x);
    std::array<int, 2> windings{};
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      windings[line[i].layer] += line[i].winding;
      if (line[i + 1].x - line[i].x > least && is_inside(windings[0], a.paint.fill_rule) &&
          is_inside(windings[1], b.paint.fill_rule)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace wavecurve::motion
