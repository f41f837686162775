#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace wavecurve::tracking {

/// Revisions of the current branch to be recorded after the fact, oldest first: at most `count` of those
/// that changed the library or the benchmarks and have marked kernels, evenly spaced, the first and the
/// last among them, without those of which the history has a record. Throws std::invalid_argument if
/// `root` is no clone.
std::vector<std::string> revisions_to_record(const std::filesystem::path& root,
                                             const std::filesystem::path& history,
                                             std::size_t count);

}  // namespace wavecurve::tracking
