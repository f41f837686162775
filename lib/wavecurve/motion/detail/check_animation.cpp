#include "wavecurve/motion/detail/check_animation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::motion {

namespace {

void demand(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument(message);
}

template <class Key>
void check_times(const std::string& layer, const char* what, const std::vector<Key>& keys,
                 double duration) {
  demand(!keys.empty(), fmt::format("{} has no {} key", layer, what));
  // Times that were computed may pass the end by their rounding.
  const double end = duration * (1 + 1e-12);
  double before = -1;
  for (const Key& key : keys) {
    demand(key.time >= 0 && key.time <= end,
           fmt::format("{}: {} key at {} s is outside 0 .. {} s", layer, what, key.time, duration));
    demand(key.time > before,
           fmt::format("{}: {} key at {} s follows one at {} s", layer, what, key.time, before));
    before = key.time;
  }
}

void check_outline(const std::string& layer, const std::vector<OutlineKey>& keys) {
  const std::vector<Contour>& first = keys.front().contours;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const std::vector<Contour>& contours = keys[k].contours;
    demand(contours.size() == first.size(),
           fmt::format("{} has {} contours in key 0 and {} in key {}", layer, first.size(),
                       contours.size(), k));
    for (std::size_t i = 0; i < contours.size(); ++i) {
      demand(contours[i].rows() > 0, fmt::format("{}: contour {} has no points", layer, i));
      demand(contours[i].rows() == first[i].rows(),
             fmt::format("{}: contour {} has {} points in key 0 and {} in key {}", layer, i,
                         first[i].rows(), contours[i].rows(), k));
      demand(contours[i].allFinite(),
             fmt::format("{}: contour {} has a point in key {} that is not finite", layer, i, k));
    }
  }
}

void check_order(const Animation& animation) {
  double before = -1;
  for (const OrderKey& key : animation.order) {
    demand(key.time > before && key.time >= 0,
           fmt::format("order key at {} s follows one at {} s", key.time, before));
    before = key.time;
    std::vector<std::size_t> order = key.order;
    std::sort(order.begin(), order.end());
    const bool names_each_once = std::adjacent_find(order.begin(), order.end()) == order.end() &&
                                 (order.empty() || order.back() < animation.layers.size());
    demand(names_each_once,
           fmt::format("order key at {} s does not name each of its {} layers once", key.time,
                       animation.layers.size()));
  }
}

bool is_finite(const Paint& paint) {
  double sum = paint.fill_opacity + paint.stroke_opacity + paint.stroke_width + paint.miter_limit;
  if (paint.fill) sum += paint.fill->red + paint.fill->green + paint.fill->blue;
  if (paint.stroke) sum += paint.stroke->red + paint.stroke->green + paint.stroke->blue;
  return std::isfinite(sum);
}

void check_paint(const std::string& layer, const std::vector<PaintKey>& keys) {
  const Paint& first = keys.front().paint;
  for (const PaintKey& key : keys) {
    demand(key.paint.fill.has_value() == first.fill.has_value() &&
               key.paint.stroke.has_value() == first.stroke.has_value(),
           fmt::format("{} has a fill or a stroke in some keys only", layer));
    demand(is_finite(key.paint), fmt::format("{} has a paint that is not finite", layer));
  }
}

}  // namespace

void check_animation(const Animation& animation) {
  const ViewBox& box = animation.view_box;
  demand(std::isfinite(box.x) && std::isfinite(box.y) && std::isfinite(box.width) &&
             std::isfinite(box.height) && box.width > 0 && box.height > 0,
         fmt::format("view box {} {} {} {} has no area", box.x, box.y, box.width, box.height));
  // Within these bounds a rate of frames is finite in every format.
  demand(animation.duration >= 1e-6 && animation.duration <= 1e9,
         must_be("duration", animation.duration, "from 1e-6 to 1e9 seconds"));
  for (const AnimatedLayer& layer : animation.layers) {
    const std::string name = "layer '" + layer.id + "'";
    check_times(name, "outline", layer.outline, animation.duration);
    check_times(name, "paint", layer.paint, animation.duration);
    check_outline(name, layer.outline);
    check_paint(name, layer.paint);
  }
  check_order(animation);
}

}  // namespace wavecurve::motion
