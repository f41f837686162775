#include "wavecurve/io/read_drawing.hpp"

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "wavecurve/io/read_points.hpp"
#include "wavecurve/io/svg/read_svg.hpp"
#include "wavecurve/io/svg/text.hpp"

namespace wavecurve::io {

namespace {

constexpr std::size_t largest_file = std::size_t{256} << 20;

/// At most one byte more than the largest file: a device may have no end.
std::string read_bytes(const std::filesystem::path& path) {
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
  constexpr std::size_t step = std::size_t{1} << 20;
  while (file && bytes.size() <= largest_file) {
    const std::size_t size = bytes.size();
    bytes.resize(size + step);
    file.read(bytes.data() + size, step);
    bytes.resize(size + static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof() && bytes.size() <= largest_file) {
    throw std::system_error(errno, std::generic_category(), "cannot read " + path.string());
  }
  return bytes;
}

}  // namespace

DrawingFile read_drawing(const std::filesystem::path& path) {
  const std::string ending = lower_case(path.extension().string());
  const auto refuse = [&](std::string_view defect) {
    throw std::invalid_argument(fmt::format("{}: {}", path.string(), defect));
  };
  if (ending != ".svg" && ending != ".csv") refuse("a drawing is read from .svg or .csv");
  const std::string too_large = fmt::format("larger than {} bytes", largest_file);
  if (std::filesystem::is_regular_file(path) && std::filesystem::file_size(path) > largest_file) {
    refuse(too_large);
  }
  const std::string bytes = read_bytes(path);
  if (bytes.empty()) refuse("the file is empty");
  if (bytes.size() > largest_file) refuse(too_large);
  try {
    return ending == ".svg" ? read_svg(bytes) : read_points(bytes);
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
  return {};
}

}  // namespace wavecurve::io
