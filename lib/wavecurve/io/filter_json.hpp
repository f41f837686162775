#pragma once

#include <filesystem>

#include "wavecurve/filters/user_filter.hpp"

namespace wavecurve::io {

/// Reads a user's filter. Either of two forms:
///   {"name": "mine", "taps": ["0.48...", ...], "first_index": 0, "sum": "sqrt2",
///    "dual": {"taps": [...], "first_index": -1}, "vanishing_moments": 2,
///    "dual_vanishing_moments": 2, "accuracy": "1e-12"}
/// where all but "taps" may be left out, or what `wavecurve filter NAME --format json` prints
/// ("analysis_low" and "synthesis_low"), with the same keys besides. Numbers may stand in quotes or
/// not; every digit that is written counts, and a tap may be a fraction in quotes, "75/64".
/// "sum" ("sqrt2", "1", "2") and "accuracy" (a bound of the error of every tap, as printed) hold for
/// both sides, or are given for each, {"primal": "2", "dual": "1"}, or stand in "dual" as well.
/// What is read is user_filter.hpp; what it means, certified/user_filter.hpp.
///
/// Throws std::invalid_argument, naming the file, the place in the document and the defect, for an
/// unknown key, a value of another kind, what is no JSON, a file of more than a mebibyte;
/// std::system_error if it is not readable.
UserFilter read_filter_json(const std::filesystem::path& path);

}  // namespace wavecurve::io
