#pragma once

#include <Eigen/Core>

namespace wavecurve {

/// Points of a closed planar curve, one a row, columns x and y; the last point is joined to the
/// first. As in SVG, x points right and y points down, so a clockwise curve, as seen, has a
/// positive signed area sum_i (x_i y_{i+1} - x_{i+1} y_i) / 2.
using Contour = Eigen::Matrix<double, Eigen::Dynamic, 2>;

}  // namespace wavecurve
