#pragma once

#include <vector>

#include "wavecurve/motion/animation.hpp"

namespace wavecurve::motion {

/// Paint on the way from one to another, as keys with times 0 .. duration. Colours move on the
/// straight line in OKLab (colour_line), opacities and widths linearly; caps and
/// joins switch at half the time. A stroke that only one of them has starts from, or ends with, no
/// width. A fill that only one of them has is there all the time, for an outline that has no area at
/// the other end. Where an outline becomes a solid, both have the outline's colour there. The rule is
/// evenodd where one of them has such a fill.
std::vector<PaintKey> blend_paint(const Paint& from, const Paint& to, double duration);

/// The paint of a layer that is to vanish: a stroke, which would leave a dot, has no width.
Paint vanishing(Paint paint);

}  // namespace wavecurve::motion
