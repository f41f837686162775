#pragma once

#include <string>

#include "wavecurve/io/files/detail/decimals.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// An animation whose contours are control points: with `cubic`, three rows a vertex as fit_cubics
/// has them; else the vertices of polygons and lines. Since both are mixed linearly in time, it is an animation like another:
/// frame_at gives the control points at any time.
struct AnimatedControlPoints {
  motion::Animation animation;
  bool cubic = false;
};

/// Tolerance 0: the polygons, with all keys. Else no point is farther than the tolerance from its place
/// at any time. Keys may go: between two that are kept, the line and what it stands for are both linear
/// from each key to the next, and so their distance is convex there and largest at a key. Where keys are
/// gone they have half of the tolerance, and the cubics the other half; each cubic is a fixed linear map
/// of the points of a key, so that distances at a time between kept keys are mixed as they are.
/// Throws as check_animation does.
AnimatedControlPoints control_points(const motion::Animation& animation, double tolerance);

/// How the cubics of a path are written: from the vertex before them, which is short, or as they are.
enum class Coordinates { relative, absolute };

/// The `d` of an SVG path; contours are closed but those that are `open`.
std::string path_data(const std::vector<Contour>& contours, bool cubic, const Decimals& decimals,
                      const std::vector<bool>& open = {},
                      Coordinates coordinates = Coordinates::relative);

/// Layers as SVG paths, the lowest first.
std::string layers_svg(const std::vector<motion::FrameLayer>& layers, bool cubic,
                       const Decimals& decimals);

}  // namespace wavecurve::io
