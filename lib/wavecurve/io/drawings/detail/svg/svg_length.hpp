#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Geometry>

#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::io {

/// The size that percentages refer to, in the units of the coordinates in force.
struct Viewport {
  double width = 0, height = 0;
  double diagonal() const;  ///< sqrt((width^2 + height^2) / 2), of what is neither
};

/// A finite decimal, or nothing.
std::optional<double> parse_number(std::string_view text);

/// A number with or without a unit, in px, or nothing. 1em is 16px: fonts are not read.
std::optional<double> parse_length(std::string_view text, double hundred_percent);

/// The four numbers of the attribute viewBox. Throws std::invalid_argument with the text if they
/// are not, or if a size is not positive.
ViewBox parse_view_box(std::string_view text);

/// That of a drawing of this width and height: of no size unless both are lengths above 0.
ViewBox box_of_lengths(std::string_view width, std::string_view height);

/// Maps a view box to where it is shown, as the attribute preserveAspectRatio demands.
Eigen::Affine2d view_box_transform(const ViewBox& box, const ViewBox& shown,
                                   std::string_view preserve_aspect_ratio);

}  // namespace wavecurve::io
