#include "wavecurve/motion/chain.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::motion {

namespace {

/// Appends the legs one by one.
struct LegChain {
  Animation animation;
  std::set<std::string> ids = {};

  void append(const Animation& leg) {
    const double start = animation.duration;
    const std::size_t first = animation.layers.size();
    for (AnimatedLayer layer : leg.layers) {
      layer.id = unique(layer.id);
      for (OutlineKey& key : layer.outline) key.time += start;
      for (PaintKey& key : layer.paint) key.time += start;
      animation.layers.push_back(std::move(layer));
    }
    append_order(start, order_at(leg, 0), first);
    for (const OrderKey& key : leg.order) {
      if (key.time > 0) append_order(start + key.time, key.order, first);
    }
    animation.duration += leg.duration;
  }

  void append_order(double time, std::vector<std::size_t> order, std::size_t first) {
    for (std::size_t& layer : order) layer += first;
    // An order that changes as a leg ends gives way to that of the next.
    if (!animation.order.empty() && animation.order.back().time >= time) animation.order.pop_back();
    animation.order.push_back({time, std::move(order)});
  }

  std::string unique(const std::string& id) {
    std::string name = id;
    for (int number = 2; !ids.insert(name).second; ++number)
      name = fmt::format("{}-{}", id, number);
    return name;
  }
};

}  // namespace

Animation chain(const std::vector<Animation>& legs) {
  check_at_least("the number of animations in a chain", legs.size(), 1);
  if (legs.size() == 1) return legs.front();
  LegChain whole{{legs.front().view_box, 0, {}}};
  for (const Animation& leg : legs) whole.append(leg);
  return std::move(whole.animation);
}

Drawing fitted(const Drawing& drawing, const ViewBox& box) {
  const ViewBox& own = drawing.view_box;
  if (own == box) return drawing;
  const double scale = std::min(box.width / own.width, box.height / own.height);
  const Eigen::Vector2d from(own.x + own.width / 2, own.y + own.height / 2);
  const Eigen::Vector2d to(box.x + box.width / 2, box.y + box.height / 2);
  Drawing result = drawing;
  result.view_box = box;
  for (Layer& layer : result.layers) {
    layer.paint.stroke_width *= scale;
    for (Subpath& subpath : layer.subpaths) {
      for (BezierSegment& segment : subpath.segments) {
        segment.control = ((segment.control.colwise() - from) * scale).colwise() + to;
      }
    }
  }
  return result;
}

}  // namespace wavecurve::motion
