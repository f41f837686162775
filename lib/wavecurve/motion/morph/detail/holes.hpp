#pragma once

#include <vector>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::motion {

/// Which contours of an outline bound a hole: is_hole of each. Where contours cross or touch each
/// other the plain way is the definition, and it is taken as long as it is quick; of more than
/// `most_plain` pairs of a contour and an edge they are taken not to, and a line sweeps over them: N
/// log N operations for N points.
std::vector<bool> holes(const std::vector<Contour>& outline, FillRule rule,
                        double most_plain = 1e8);

}  // namespace wavecurve::motion
