#pragma once

#include <string_view>

#include <Eigen/Geometry>

#include "wavecurve/io/drawings/detail/svg/style_sheet.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_length.hpp"

namespace wavecurve::io {

/// The property `transform` of CSS: functions of the plane, with units; percentages of a translation are of
/// the view box. Throws std::invalid_argument naming what is none.
Eigen::Affine2d parse_css_transform(std::string_view text, const Viewport& viewport);

/// That of an element, by its property or else its attribute `transform`, about its origin. Throws
/// std::invalid_argument likewise.
Eigen::Affine2d transform_of(const XmlElement& element, const Properties& properties,
                             const Viewport& viewport);

/// Whether all lengths are scaled alike, but for a rounding error.
bool scales_evenly(const Eigen::Affine2d& transform);

/// The point that stays, by `transform-origin`: one or two lengths, percentages of the view box, or
/// words such as left and center. Throws std::invalid_argument likewise.
Eigen::Vector2d parse_transform_origin(std::string_view text, const Viewport& viewport);

}  // namespace wavecurve::io
