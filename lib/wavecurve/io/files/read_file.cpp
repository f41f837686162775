#include "wavecurve/io/files/read_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "wavecurve/io/files/detail/cannot_open.hpp"

namespace wavecurve::io {

namespace {

constexpr std::size_t largest_step = std::size_t{1} << 20;

}  // namespace

std::string read_file(const std::filesystem::path& path, std::size_t most) {
  const auto refuse = [&](const std::string& reason) {
    throw std::invalid_argument("cannot read " + path.string() + ": " + reason);
  };
  const std::string too_large = "it is larger than " + std::to_string(most) + " bytes";
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse("it is a directory");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) cannot_open(path, errno);
  if (std::filesystem::is_regular_file(path, ignored) &&
      std::filesystem::file_size(path, ignored) > most) {
    refuse(too_large);
  }
  std::string bytes;
  while (file && bytes.size() <= most) {
    const std::size_t size = bytes.size(), step = std::min(most - size + 1, largest_step);
    bytes.resize(size + step);
    file.read(bytes.data() + size, static_cast<std::streamsize>(step));
    bytes.resize(size + static_cast<std::size_t>(file.gcount()));
  }
  if (!file && !file.eof()) {
    throw std::system_error(errno, std::generic_category(), "cannot read " + path.string());
  }
  if (bytes.size() > most) refuse(too_large);
  return bytes;
}

}  // namespace wavecurve::io
