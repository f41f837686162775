#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::motion {

/// How often a closed polygon winds round a point, clockwise as seen; exact, and for a point on the
/// polygon that of one of its sides.
int winding_number(const Eigen::Ref<const Contour>& contour, const Eigen::Vector2d& point);

/// Whether a fill rule fills what a drawing winds round so often.
bool is_filled(int winding, FillRule rule);

/// A point surely inside: the mean of the vertices if it lies inside, else the middle of the widest
/// inner stretch on a few horizontal lines; for a contour that encloses nothing, its vertex nearest
/// to the mean.
Eigen::Vector2d interior_point(const Eigen::Ref<const Contour>& contour);

}  // namespace wavecurve::motion
