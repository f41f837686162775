#pragma once

#include <string>

#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// A sheet of options.frames equidistant frames as one SVG, to be read in the order of left to
/// right and top to bottom: the source at the upper left, the destination at the lower right, under
/// each its share tau of the duration. Publication, Figure 4. Throws as check_animation does.
std::string animation_sheet(const motion::Animation& animation, const OutputOptions& options = {});

}  // namespace wavecurve::io
