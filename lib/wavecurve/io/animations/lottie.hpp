#pragma once

#include <string>

#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// A Lottie animation (JSON): a shape layer each, with the animation's own keys, linear in between:
/// two where a layer moves linearly. The view box is scaled to options.pixels, for Lottie's sizes
/// are whole numbers. Frame i of options.frames, counted from 0, is the time
/// duration i / (frames - 1).
/// Throws as check_animation does: schema validators do not see unequal vertex counts.
std::string lottie(const motion::Animation& animation, const OutputOptions& options = {});

}  // namespace wavecurve::io
