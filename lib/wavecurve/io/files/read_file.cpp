#include "wavecurve/io/files/read_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace wavecurve::io {

namespace {

constexpr std::size_t largest_step = std::size_t{1} << 20;

}  // namespace

std::string read_file(const std::filesystem::path& path, std::size_t bound) {
  if (std::filesystem::is_directory(path)) {
    throw std::invalid_argument("cannot read " + path.string() + ": it is a directory");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw std::invalid_argument("cannot read " + path.string() + ": " +
                                std::generic_category().message(errno));
  }
  std::string bytes;
  while (file && bytes.size() <= bound) {
    const std::size_t size = bytes.size(), step = std::min(bound + 1 - size, largest_step);
    bytes.resize(size + step);
    file.read(bytes.data() + size, static_cast<std::streamsize>(step));
    bytes.resize(size + static_cast<std::size_t>(file.gcount()));
  }
  if (!file && !file.eof()) {
    throw std::system_error(errno, std::generic_category(), "cannot read " + path.string());
  }
  return bytes;
}

}  // namespace wavecurve::io
