#pragma once

#include "wavecurve/motion/animation.hpp"

namespace wavecurve::motion {

/// Whether the fills of two layers have an area in common: seen at 64 heights of the box that both have in common, so
/// that what is less high than a 64th of it may be missed. Where outlines only touch there is none; where they lie on
/// each other, there is.
bool share_area(const FrameLayer& a, const FrameLayer& b);

}  // namespace wavecurve::motion
