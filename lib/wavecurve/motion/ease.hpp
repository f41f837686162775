#pragma once

#include "wavecurve/motion/animation.hpp"

namespace wavecurve::motion {

/// How time passes in an animation: evenly, from rest, to rest, or both.
enum class Ease { linear, in, out, in_out };

/// The share of the way at a share s of the time: s, s^2, 1 - (1 - s)^2, or 3 s^2 - 2 s^3.
double eased(Ease ease, double share);

/// The animation with time passing so: keys at `frames` equidistant times, the first at the
/// beginning and the last at the end, each exact, linear in between. With Ease::linear it is left
/// as it is. Throws std::invalid_argument unless frames >= 2.
Animation eased(const Animation& animation, Ease ease, int frames);

}  // namespace wavecurve::motion
