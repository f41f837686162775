#pragma once

#include <filesystem>
#include <string>

namespace wavecurve::io {

/// The bytes of a file. Throws std::invalid_argument naming the path and the reason if it cannot be
/// read, also for a directory.
std::string read_file(const std::filesystem::path& path);

}  // namespace wavecurve::io
