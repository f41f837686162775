#pragma once

#include <filesystem>

namespace wavecurve::io {

/// Throws for a file that open() has refused with the error: std::system_error where the machine
/// lacks something (memory, descriptors, a disk that answers), and std::invalid_argument where the
/// path is wrong. Both name the path and the reason.
[[noreturn]] void cannot_open(const std::filesystem::path& path, int error);

}  // namespace wavecurve::io
