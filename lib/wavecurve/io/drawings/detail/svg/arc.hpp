#pragma once

#include "wavecurve/io/drawings/detail/svg/path_builder.hpp"

namespace wavecurve::io {

/// An ellipse whose axes are rotated by `rotation` radians.
struct Ellipse {
  Eigen::Vector2d centre, radii;
  double rotation = 0;

  /// centre + R (rx cos angle, ry sin angle)
  Eigen::Vector2d at(double angle) const;
};

/// Appends the arc from angle `from` over `sweep` radians (positive is clockwise as seen, y down)
/// as cubic segments of at most pi / 24 each. Their control points lie on the tangents at the
/// distance k = 4/3 tan(theta / 4) of the unit circle; with tau = tan(theta / 4),
///     |B(s)|^2 - 1 = 16 tau^6 / (1 + tau^2)^2  s^2 (1 - s)^2 (1 - 2 s)^2,
/// since the left side is of degree six and has double zeros at both ends and in the middle. The
/// last factors are at most 1/108, so the radius is at most 2/27 sin^6(theta/4) / cos^2(theta/4)
/// too large: 9.1e-11 of it for theta = pi / 24.
void append_arc(PathBuilder& path, const Ellipse& ellipse, double from, double sweep);

/// The command A of path data: from the current point to `to`, rotation in degrees. Radii that are
/// too small are enlarged, a radius of zero gives a line (SVG 1.1, appendix F.6). Throws
/// std::invalid_argument naming them where they are too large for a centre.
void append_endpoint_arc(PathBuilder& path, const Eigen::Vector2d& radii, double rotation,
                         bool large, bool clockwise, const Eigen::Vector2d& to);

}  // namespace wavecurve::io
