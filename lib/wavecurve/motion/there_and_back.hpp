#pragma once

#include "wavecurve/motion/animation.hpp"

namespace wavecurve::motion {

/// The animation followed by itself backwards, twice as long: its end is its beginning, so that it
/// loops without a jump.
Animation there_and_back(const Animation& animation);

}  // namespace wavecurve::motion
