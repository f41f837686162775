#pragma once

#include <string>

#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// A self-animating SVG (SMIL): one path a layer, whose data, colours, opacities and stroke
/// width are animated between the animation's own keys, which is exact, for they are linear in
/// between. Browsers play it, also as an image; others show the first frame.
/// Throws as check_animation does.
std::string animated_svg(const motion::Animation& animation, const OutputOptions& options = {});

}  // namespace wavecurve::io
