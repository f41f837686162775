#include "wavecurve/motion/morph/detail/painting_order.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include <Eigen/Geometry>

#include "wavecurve/curves/crossings.hpp"
#include "wavecurve/motion/morph/detail/nesting.hpp"

namespace wavecurve::motion {

namespace {

using Box = Eigen::AlignedBox2d;
using LayerIndex = std::optional<std::size_t>;

std::vector<Box> boxes_of(const std::vector<FrameLayer>& layers) {
  std::vector<Box> boxes(layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const double margin = layers[i].paint.stroke ? layers[i].paint.stroke_width / 2 : 0;
    for (const Contour& contour : layers[i].contours) {
      boxes[i].extend(Eigen::Vector2d(contour.colwise().minCoeff().array() - margin));
      boxes[i].extend(Eigen::Vector2d(contour.colwise().maxCoeff().array() + margin));
    }
  }
  return boxes;
}

bool is_below(LayerIndex a, LayerIndex b, const std::vector<Box>& boxes) {
  return a && b && *a < *b && boxes[*a].intersects(boxes[*b]);
}

/// Whether outlines really overlap: they cross, or one holds a point of the other.
bool overlap(const FrameLayer& a, const FrameLayer& b) {
  for (const Contour& p : a.contours) {
    for (const Contour& q : b.contours) {
      if (winding_number(p, q.row(0)) != 0 || winding_number(q, p.row(0)) != 0 ||
          count_crossings(p, q) > 0) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<LayerMatch> painting_order(const std::vector<LayerMatch>& matches,
                                       const std::vector<FrameLayer>& source,
                                       const std::vector<FrameLayer>& destination) {
  const std::vector<Box> source_boxes = boxes_of(source), end_boxes = boxes_of(destination);
  // Decides between two matches that the boxes order one way in the source and the other in the destination.
  const auto source_decides = [&](const LayerMatch& a, const LayerMatch& b) {
    return overlap(source[*a.source], source[*b.source]) ||
           !overlap(destination[*a.destination], destination[*b.destination]);
  };
  const auto comes_first = [&](const LayerMatch& a, const LayerMatch& b) {
    const bool in_source = is_below(a.source, b.source, source_boxes);
    const bool at_end = is_below(a.destination, b.destination, end_boxes);
    if (in_source && is_below(b.destination, a.destination, end_boxes)) {
      return source_decides(a, b);
    }
    if (at_end && is_below(b.source, a.source, source_boxes)) return !source_decides(a, b);
    return in_source || at_end;
  };
  const auto count = static_cast<Eigen::Index>(matches.size());
  Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic> precedes(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      precedes(i, j) =
          comes_first(matches[static_cast<std::size_t>(i)], matches[static_cast<std::size_t>(j)]);
    }
  }
  std::vector<Eigen::Index> left(matches.size());
  std::iota(left.begin(), left.end(), 0);
  // How many of those left come before each.
  Eigen::VectorX<Eigen::Index> waits_for =
      precedes.cast<Eigen::Index>().colwise().sum().transpose();
  std::vector<LayerMatch> ordered;
  while (!left.empty()) {
    auto next = std::find_if(left.begin(), left.end(),
                             [&](Eigen::Index candidate) { return waits_for[candidate] == 0; });
    if (next == left.end()) next = left.begin();  // a circle of demands
    ordered.push_back(matches[static_cast<std::size_t>(*next)]);
    waits_for -= precedes.row(*next).cast<Eigen::Index>().transpose();
    left.erase(next);
  }
  return ordered;
}

}  // namespace wavecurve::motion
