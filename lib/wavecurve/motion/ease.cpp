#include "wavecurve/motion/ease.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::motion {

double eased(Ease ease, double share) {
  switch (ease) {
    case Ease::linear:
      return share;
    case Ease::in:
      return share * share;
    case Ease::out:
      return 1 - (1 - share) * (1 - share);
    case Ease::in_out:
      return share * share * (3 - 2 * share);
  }
  return share;
}

namespace {

/// Every frame becomes a key, with all its points.
void check_keys(const Animation& animation, int frames) {
  constexpr double most_points = double{1 << 25};
  double points = 0;
  for (const AnimatedLayer& layer : animation.layers) {
    if (layer.outline.empty()) continue;
    for (const Contour& contour : layer.outline.front().contours) {
      points += static_cast<double>(contour.rows());
    }
  }
  if (points * frames <= most_points) return;
  throw std::domain_error(fmt::format("{} frames of {} points are more than {} points together",
                                      frames, points, most_points));
}

}  // namespace

Animation eased(const Animation& animation, Ease ease, int frames) {
  check_at_least("frames", frames, 2);
  if (ease == Ease::linear) return animation;
  check_keys(animation, frames);
  Animation result{animation.view_box, animation.duration, {}};
  for (const AnimatedLayer& layer : animation.layers) {
    result.layers.push_back({layer.id, {}, {}, layer.open});
  }
  std::size_t order = 0;
  for (int i = 0; i < frames; ++i) {
    const double share = static_cast<double>(i) / (frames - 1), time = animation.duration * share;
    const double even_time = animation.duration * eased(ease, share);
    for (std::size_t k = 0; k < animation.layers.size(); ++k) {
      FrameLayer layer = layer_at(animation.layers[k], even_time);
      result.layers[k].outline.push_back({time, std::move(layer.contours)});
      result.layers[k].paint.push_back({time, layer.paint});
    }
    const std::size_t before = order;
    while (order < animation.order.size() && animation.order[order].time <= even_time) ++order;
    if (order > before) result.order.push_back({time, animation.order[order - 1].order});
  }
  return result;
}

}  // namespace wavecurve::motion
