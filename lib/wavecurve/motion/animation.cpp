#include "wavecurve/motion/animation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>

namespace wavecurve::motion {

namespace {

/// The key at or before a time, and the share of the way to the next one.
struct Place {
  std::size_t key = 0;
  double share = 0;
};

template <class Key>
Place place(const std::vector<Key>& keys, double time) {
  const auto after = std::upper_bound(keys.begin(), keys.end(), time,
                                      [](double t, const Key& key) { return t < key.time; });
  if (after == keys.begin()) return {0, 0};
  const std::size_t key = static_cast<std::size_t>(after - keys.begin()) - 1;
  if (after == keys.end()) return {key, 0};
  return {key, (time - keys[key].time) / (after->time - keys[key].time)};
}

std::optional<Colour> mix(const std::optional<Colour>& a, const std::optional<Colour>& b,
                          double share) {
  if (!a || !b) return a;
  return Colour{std::lerp(a->red, b->red, share), std::lerp(a->green, b->green, share),
                std::lerp(a->blue, b->blue, share)};
}

Paint mix(const Paint& a, const Paint& b, double share) {
  Paint paint = a;
  paint.fill = mix(a.fill, b.fill, share);
  paint.stroke = mix(a.stroke, b.stroke, share);
  paint.fill_opacity = std::lerp(a.fill_opacity, b.fill_opacity, share);
  paint.stroke_opacity = std::lerp(a.stroke_opacity, b.stroke_opacity, share);
  paint.stroke_width = std::lerp(a.stroke_width, b.stroke_width, share);
  paint.miter_limit = std::lerp(a.miter_limit, b.miter_limit, share);
  return paint;
}

std::vector<Contour> outline_at(const std::vector<OutlineKey>& keys, double time) {
  const Place at = place(keys, time);
  std::vector<Contour> contours = keys[at.key].contours;
  if (at.share == 0) return contours;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    contours[i] = (1 - at.share) * contours[i] + at.share * keys[at.key + 1].contours[i];
  }
  return contours;
}

Paint paint_at(const std::vector<PaintKey>& keys, double time) {
  const Place at = place(keys, time);
  if (at.share == 0) return keys[at.key].paint;
  return mix(keys[at.key].paint, keys[at.key + 1].paint, at.share);
}

}  // namespace

FrameLayer layer_at(const AnimatedLayer& layer, double time) {
  return {layer.id, outline_at(layer.outline, time), paint_at(layer.paint, time), layer.open};
}

std::vector<std::size_t> order_at(const Animation& animation, double time) {
  const auto& keys = animation.order;
  const auto after = std::upper_bound(keys.begin(), keys.end(), time,
                                      [](double t, const OrderKey& key) { return t < key.time; });
  if (after != keys.begin()) return std::prev(after)->order;
  std::vector<std::size_t> order(animation.layers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

std::vector<FrameLayer> frame_at(const Animation& animation, double time) {
  std::vector<FrameLayer> frame;
  for (const std::size_t i : order_at(animation, time)) {
    frame.push_back(layer_at(animation.layers[i], time));
  }
  return frame;
}

}  // namespace wavecurve::motion
