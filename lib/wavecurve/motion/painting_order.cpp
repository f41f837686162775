#include "wavecurve/motion/painting_order.hpp"

#include <algorithm>
#include <cstddef>

#include <Eigen/Geometry>

namespace wavecurve {

namespace {

using Box = Eigen::AlignedBox2d;
using Place = std::optional<std::size_t>;

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

bool is_below(Place a, Place b, const std::vector<Box>& boxes) {
  return a && b && *a < *b && boxes[*a].intersects(boxes[*b]);
}

}  // namespace

std::vector<LayerMatch> painting_order(const std::vector<LayerMatch>& matches,
                                       const std::vector<FrameLayer>& source,
                                       const std::vector<FrameLayer>& destination) {
  const std::vector<Box> source_boxes = boxes_of(source), end_boxes = boxes_of(destination);
  const auto comes_first = [&](const LayerMatch& a, const LayerMatch& b) {
    return is_below(a.source, b.source, source_boxes) ||
           (is_below(a.destination, b.destination, end_boxes) &&
            !is_below(b.source, a.source, source_boxes));
  };
  std::vector<LayerMatch> left = matches, ordered;
  while (!left.empty()) {
    auto next = std::find_if(left.begin(), left.end(), [&](const LayerMatch& candidate) {
      return std::none_of(left.begin(), left.end(),
                          [&](const LayerMatch& other) { return comes_first(other, candidate); });
    });
    if (next == left.end()) next = left.begin();  // a circle of demands
    ordered.push_back(*next);
    left.erase(next);
  }
  return ordered;
}

}  // namespace wavecurve
