#pragma once

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/curves/path.hpp"

namespace wavecurve {

/// The enclosed area, positive for a curve that is clockwise as seen (y points down); the last
/// point is joined to the first. That of a subpath is exact for its curves up to rounding.
double signed_area(const Contour& contour);
double signed_area(const Subpath& subpath);

}  // namespace wavecurve
