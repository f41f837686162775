#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace wavecurve::io {

/// What a gzip file unpacks to; of more than the bound, the first bound + 1 bytes. A file without
/// gzip's mark is taken as it is. Throws std::invalid_argument naming the path and the reason if it
/// cannot be opened or is damaged; std::system_error if reading fails.
std::string read_gzip(const std::filesystem::path& path, std::size_t bound);

}  // namespace wavecurve::io
