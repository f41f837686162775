#include "wavecurve/motion/there_and_back.hpp"

#include <cstddef>

namespace wavecurve::motion {

namespace {

template <class Key>
void append_reversed(std::vector<Key>& keys, double duration) {
  for (std::size_t k = keys.size(); k-- > 0;) {
    if (keys[k].time >= duration) continue;  // the turning point is there already
    Key key = keys[k];
    key.time = 2 * duration - key.time;
    keys.push_back(std::move(key));
  }
}

}  // namespace

Animation there_and_back(const Animation& animation) {
  Animation result = animation;
  result.duration = 2 * animation.duration;
  for (AnimatedLayer& layer : result.layers) {
    append_reversed(layer.outline, animation.duration);
    append_reversed(layer.paint, animation.duration);
  }
  for (std::size_t k = animation.order.size(); k-- > 0;) {
    const OrderKey& key = animation.order[k];
    if (key.time == 0) continue;  // there was no other order
    result.order.push_back({2 * animation.duration - key.time,
                            order_at(animation, k == 0 ? -1 : animation.order[k - 1].time)});
  }
  return result;
}

}  // namespace wavecurve::motion
