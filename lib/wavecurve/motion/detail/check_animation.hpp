#pragma once

#include "wavecurve/motion/animation.hpp"

namespace wavecurve::motion {

/// Throws std::invalid_argument, naming the layer, unless the animation is as its types say: keys
/// in increasing time within the duration, the same number of contours with the same numbers of
/// points in every key of a layer, fills and strokes in all keys or none, everything finite, view
/// box and duration positive. Players do not notice: they show garbage.
void check_animation(const Animation& animation);

}  // namespace wavecurve::motion
