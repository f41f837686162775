#pragma once

#include <vector>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/curves/crossings.hpp"

namespace wavecurve {

/// Closed cubic Bezier curves through keys of one moving contour, with few vertices: the same
/// number in every key, at the same points. A result has three rows a vertex: the vertex, which is
/// one of the contour's points, the handle after it, and the handle before the next vertex.
///
/// Between two vertices the points belong to equidistant parameters of the cubic; no point of any
/// key is farther than the tolerance from the cubic at its parameter. Curves are smooth at vertices
/// but at corners. The handles minimise the sum of squares: one linear map of the points, the same
/// for all keys. So it holds between keys too: where points and control points are mixed linearly,
/// so are the distances.
///
/// Keys: the same contour at different times, equal numbers of points (std::invalid_argument).
/// The tolerance is at least 0, in units of the points.
///
/// With Closing::open the points are a line from the first to the last, and so is the result: it has
/// one row more, the last vertex. Keys that are a point but for rounding have no corners.
std::vector<Contour> fit_cubics(const std::vector<Contour>& keys, double tolerance,
                                Closing closing = Closing::joined);

}  // namespace wavecurve
