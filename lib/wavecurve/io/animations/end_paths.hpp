#pragma once

#include <string>

#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// Both ends of an animation as JSON, for CSS or your own tweening: the id of each layer and, as
/// `source` and `destination`, the `d` of an SVG path and the attributes of its paint. The two paths of a
/// layer have the same commands in absolute coordinates, so that their numbers may be mixed one by one.
/// Layers stand in the source's painting order; `destination_order` has the ids in the destination's,
/// where that is another. Throws as check_animation does.
std::string end_paths(const motion::Animation& animation, const OutputOptions& options = {});

}  // namespace wavecurve::io
