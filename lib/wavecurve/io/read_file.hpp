#pragma once

#include <filesystem>
#include <string>

namespace wavecurve::io {

/// The bytes of a file. Throws std::system_error naming the path, also for a directory.
std::string read_file(const std::filesystem::path& path);

}  // namespace wavecurve::io
