#pragma once

#include <filesystem>
#include <string>

#include "wavecurve/curves/descriptor.hpp"

namespace wavecurve::io {

/// A descriptor as JSON, every number the shortest decimal that is read back as the same double:
///   {"format": "wavecurve-descriptor", "version": 1,
///    "filter": "db4", "samples": 256, "levels": 4, "mode": "samples" | "interpolate",
///    "corners": "ignored" | "kept", "view_box": [x, y, width, height],
///    "layers": [{"id": "nose",
///      "paint": {"fill": [red, green, blue] | null, "fill_opacity": 1, "fill_rule": "nonzero" |
///                "evenodd", "stroke": ..., "stroke_opacity": 1, "stroke_width": 1},
///      "contours": [{"closed": true, "length": 12.5, "x": [...], "y": [...]}]}]}
/// Colours are sRGB, 0 .. 1. x and y are coefficients in global-to-local order, in units of the
/// drawing: sqrt(samples) times those of the publication's (2.5). See curves/coefficients.hpp.
std::string descriptor_json(const Descriptor& descriptor);

/// Reads one. Throws std::invalid_argument naming the file and the defect, also for a version that
/// is not known, for numbers of coefficients that are not `samples`, and for what is not finite.
Descriptor read_descriptor(const std::filesystem::path& path);

}  // namespace wavecurve::io
