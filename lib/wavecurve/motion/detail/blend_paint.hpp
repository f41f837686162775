#pragma once

#include <vector>

#include "wavecurve/motion/animation.hpp"

namespace wavecurve::motion {

/// Paint on the way from one to another, as keys with times 0 .. duration. Colours move on the
/// straight line in OKLab (colour_line), opacities and widths linearly. A fill or a stroke that
/// only one of them has keeps its colour, and its width, and fades. The rule is nonzero unless both
/// are evenodd.
std::vector<PaintKey> blend_paint(const Paint& from, const Paint& to, double duration);

/// The paint of a layer that is to vanish: a stroke, which would leave a dot, has faded.
Paint vanishing(Paint paint);

}  // namespace wavecurve::motion
