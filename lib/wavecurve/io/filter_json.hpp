#pragma once

#include <filesystem>

#include "wavecurve/filters/user_filter.hpp"

namespace wavecurve::io {

/// Reads a user's filter. Either of two forms:
///   {"name": "mine", "taps": ["0.48...", ...], "first_index": 0, "sum": "sqrt2",
///    "dual": {"taps": [...], "first_index": -1}, "vanishing_moments": 2}
/// where all but "taps" may be left out, or what `wavecurve filter NAME --format json` prints
/// ("analysis_low" and "synthesis_low"). Taps are strings, so that every printed digit counts; a
/// JSON number stands for the shortest decimal of its double. Throws std::invalid_argument naming
/// the file and the defect, std::system_error if it is not readable.
UserFilter read_filter_json(const std::filesystem::path& path);

}  // namespace wavecurve::io
