#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace wavecurve::io {

/// What a reader takes, unless it says otherwise: far beyond any file that people make by hand or by
/// a program of this kind, and little enough for the memory of any machine.
inline constexpr std::size_t largest_input = std::size_t{256} << 20;

/// The bytes of a file. Throws std::invalid_argument naming the path and the reason if it cannot be
/// opened, is a directory, or has more bytes than `most`: of a device or a pipe that has no end so
/// many are read and no more. Throws std::system_error if reading fails.
std::string read_file(const std::filesystem::path& path, std::size_t most = largest_input);

}  // namespace wavecurve::io
