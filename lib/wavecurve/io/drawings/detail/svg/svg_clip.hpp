#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_style.hpp"

namespace wavecurve::io {

/// The first few shapes of the clip path with that id, which together are what is shown: none where there is no such
/// element, or it says its units in another way than the element does whose transformation is given.
std::vector<std::vector<Subpath>> clip_shapes(std::string_view id, const Eigen::Affine2d& transform,
                                              const Viewport& viewport, const StyleSource& source);

/// Whether a layer with its stroke is seen to lie within a clip shape, so that clipping changes nothing. Only
/// convex shapes of a few corners are looked at: within the polygon of the ends of their segments all
/// control points of the layer must lie, but for a rounding error.
bool is_within(const Layer& layer, const std::vector<Subpath>& clip);

}  // namespace wavecurve::io
