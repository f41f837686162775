#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "wavecurve/curves/path.hpp"

namespace wavecurve::io {

/// Coordinates beyond it, in either direction, are refused.
constexpr double largest_coordinate = 1e9;

/// Whether a subpath has no length: its control points lie within 1e-12 of each other, or nearer
/// than rounding errors of their coordinates.
bool has_no_length(const Subpath& subpath);

/// A line without length shows its caps, along the axis of x. So it becomes a straight line of this
/// length, which is to be too short to be seen.
void lengthen_dots(std::vector<Subpath>& subpaths, double length);

/// The subpaths as areas: open ones are closed by a straight line, and those that are one straight
/// line, inside of which nothing lies, are left out.
void close_areas(std::vector<Subpath>& subpaths);

/// Transforms the subpaths. Then segments whose control points coincide are left out, and ends that
/// meet but for a rounding error (1e-10 of the size) meet exactly. Throws std::invalid_argument
/// naming a coordinate that is not finite or too large, and the bound.
void transform_outline(std::vector<Subpath>& subpaths, const Eigen::Affine2d& transform);

}  // namespace wavecurve::io
