#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <Eigen/Core>

#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"

namespace wavecurve::tools {

// What the commands that take drawings share.

/// The drawing of a file; what of it is not supported is said on the error stream.
Drawing drawing_of(const std::string& path, const io::PointOptions& options = {});

/// --open and --y-up.
void add_point_options(CLI::App* command, io::PointOptions& options);

/// The value of `--scale`: a number of control points, or none for the text full. Throws
/// std::invalid_argument for another text.
std::optional<Eigen::Index> parsed_scale(const std::string& text);

}  // namespace wavecurve::tools
