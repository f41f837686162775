#pragma once

#include "wavecurve/curves/contour.hpp"

namespace wavecurve {

/// The largest distance of a point of either contour from the other closed polygon. Both sets of
/// points dense, that is the Hausdorff distance of the polygons: it misses less than half of the
/// longest side. Contours whose points correspond take about linear time, others up to the product
/// of their sizes. Both must hold a point.
double hausdorff_distance(const Contour& a, const Contour& b);

namespace plain {
/// Every point with every side.
double hausdorff_distance(const Contour& a, const Contour& b);
}  // namespace plain

}  // namespace wavecurve
