#pragma once

#include <Eigen/Core>

#include "wavecurve/curves/path.hpp"

namespace wavecurve {

/// B(s); exactly the first and the last control point at s = 0 and 1.
Eigen::Vector2d bezier_point(const BezierSegment& segment, double s);

/// The control points of B'(s), a Bezier curve of one degree less: one to three columns.
Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, 3> hodograph(
    const BezierSegment& segment);

/// Unit vectors along the segment at its start and at its end, also where the first or the last
/// control points coincide; zero for a segment that is a point.
Eigen::Vector2d start_direction(const BezierSegment& segment);
Eigen::Vector2d end_direction(const BezierSegment& segment);

/// The same curves run through from the end to the start.
BezierSegment reversed(const BezierSegment& segment);
Subpath reversed(const Subpath& subpath);

}  // namespace wavecurve
