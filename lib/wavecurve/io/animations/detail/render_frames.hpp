#pragma once

#include <functional>

#include "wavecurve/io/animations/detail/raster.hpp"
#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// Renders options.frames equidistant frames, the first at the beginning and the last at the end,
/// and hands each to the function as soon as it is there. Throws std::invalid_argument for less
/// than 2 frames, and as check_animation and raster_size do.
void render_frames(const motion::Animation& animation, const OutputOptions& options,
                   const std::function<void(const Raster&)>& take);

}  // namespace wavecurve::io
