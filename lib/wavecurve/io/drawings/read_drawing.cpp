#include "wavecurve/io/drawings/read_drawing.hpp"

#include <stdexcept>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "wavecurve/io/drawings/detail/read_points.hpp"
#include "wavecurve/io/drawings/detail/svg/read_svg.hpp"
#include "wavecurve/io/files/detail/read_gzip.hpp"
#include "wavecurve/io/files/detail/text.hpp"
#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve::io {

namespace {

/// A path, and the id of an element behind its last #, unless that is part of a file's name.
struct Place {
  std::filesystem::path path;
  std::string id;
};

Place place_of(const std::filesystem::path& path) {
  const std::string text = path.string();
  const std::size_t mark = text.rfind('#');
  std::error_code ignored;
  if (mark == std::string::npos || std::filesystem::exists(path, ignored)) return {path, {}};
  return {text.substr(0, mark), text.substr(mark + 1)};
}

std::string unpacked(const std::filesystem::path& path) {
  std::string bytes = read_gzip(path, largest_input);
  if (bytes.size() <= largest_input) return bytes;
  throw std::invalid_argument(
      fmt::format("{}: it unpacks to more than {} bytes", path.string(), largest_input));
}

}  // namespace

DrawingFile read_drawing(const std::filesystem::path& given, const PointOptions& options) {
  const auto [path, id] = place_of(given);
  const std::string ending = lower_case(path.extension().string());
  const auto refuse = [&](std::string_view defect) {
    throw std::invalid_argument(fmt::format("{}: {}", given.string(), defect));
  };
  const bool is_svg = ending == ".svg" || ending == ".svgz";
  if (!is_svg && ending != ".csv") refuse("a drawing is read from .svg, .svgz or .csv");
  if (is_svg && options != PointOptions{}) {
    refuse("that contours are open, or y points up, is said of tables of points only");
  }
  if (!is_svg && !id.empty()) refuse("an element by its id is read from .svg or .svgz only");
  const std::string bytes = ending == ".svgz" ? unpacked(path) : read_file(path);
  if (bytes.empty()) refuse("the file is empty");
  try {
    return is_svg ? read_svg(bytes, id) : read_points(bytes, options);
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
  return {};
}

}  // namespace wavecurve::io
