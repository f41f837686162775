#include "wavecurve/motion/ease.hpp"

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

Animation eased(const Animation& animation, Ease ease, int frames) {
  check_at_least("frames", frames, 2);
  if (ease == Ease::linear) return animation;
  Animation result{animation.view_box, animation.duration, {}};
  for (const AnimatedLayer& layer : animation.layers) result.layers.push_back({layer.id, {}, {}});
  for (int i = 0; i < frames; ++i) {
    const double share = static_cast<double>(i) / (frames - 1);
    auto frame = frame_at(animation, animation.duration * eased(ease, share));
    for (std::size_t k = 0; k < frame.size(); ++k) {
      const double time = animation.duration * share;
      result.layers[k].outline.push_back({time, std::move(frame[k].contours)});
      result.layers[k].paint.push_back({time, frame[k].paint});
    }
  }
  return result;
}

}  // namespace wavecurve::motion
