#pragma once

#include <filesystem>
#include <limits>
#include <string>

namespace wavecurve::io {

/// The bytes of a file; of one that is larger than the bound, or that has no end as a device may,
/// the first bound + 1. Throws std::invalid_argument naming the path and the reason if it cannot be
/// opened, also for a directory; std::system_error if reading fails.
std::string read_file(const std::filesystem::path& path,
                      std::size_t bound = std::numeric_limits<std::size_t>::max() - 1);

}  // namespace wavecurve::io
