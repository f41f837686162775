#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Geometry>

#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/io/drawings/detail/svg/path_builder.hpp"

namespace wavecurve::io {

/// Appends what the attribute `d` draws. Throws std::invalid_argument that names the character at
/// which the data are no path data, or a number too long; what comes before it has been appended.
/// Radii of arcs lose their signs; `none` draws nothing.
void parse_path_data(std::string_view text, PathBuilder& path);

/// Appends the points of the attribute `points`, joined by lines. Throws like parse_path_data.
void parse_points(std::string_view text, PathBuilder& path);

/// The product of the attribute `transform`. Throws like parse_path_data.
Eigen::Affine2d parse_transform(std::string_view text);

/// A colour by name, as #rgb, #rrggbb or rgb(), or nothing.
std::optional<Colour> parse_colour(std::string_view text);

}  // namespace wavecurve::io
