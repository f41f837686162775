#include "wavecurve/io/read_file.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

namespace wavecurve::io {

std::string read_file(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) {
    throw std::system_error(EISDIR, std::generic_category(), "cannot read " + path.string());
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw std::system_error(errno, std::generic_category(), "cannot read " + path.string());
  }
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace wavecurve::io
