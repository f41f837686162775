#pragma once

#include <filesystem>

namespace wavecurve::io {

/// Where what is written to a path goes: the path itself, without a slash at its end, or where links
/// lead, also if nothing is there yet. Throws std::system_error naming the path if they lead in a
/// circle.
std::filesystem::path output_path(const std::filesystem::path& path);

/// Whether something is there that is no plain file and cannot be replaced: a pipe, a device.
/// Folders are special too.
bool is_special(const std::filesystem::path& path);

}  // namespace wavecurve::io
