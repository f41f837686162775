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

/// Tolerance 0: the polygons. Throws as check_animation does.
AnimatedControlPoints control_points(const motion::Animation& animation, double tolerance);

/// The `d` of an SVG path; contours are closed but those that are `open`.
std::string path_data(const std::vector<Contour>& contours, bool cubic, const Decimals& decimals,
                      const std::vector<bool>& open = {});

/// Layers as SVG paths, the lowest first.
std::string layers_svg(const std::vector<motion::FrameLayer>& layers, bool cubic,
                       const Decimals& decimals);

}  // namespace wavecurve::io
