#pragma once

#include <vector>

#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::motion {

/// Animations one after the other. The layers of each are there in its own time alone, so that nothing
/// jumps where one ends as the next begins. The view box is that of the first, the duration the sum; an
/// id that an earlier layer has gets a number. Throws std::invalid_argument without an animation.
Animation chain(const std::vector<Animation>& legs);

/// The drawing scaled uniformly, with its strokes, and moved to the middle of a box, as large as fits:
/// as make_morph has the destination in the source's.
Drawing fitted(const Drawing& drawing, const ViewBox& box);

}  // namespace wavecurve::motion
