#include "wavecurve/io/drawings/read_drawing.hpp"

#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "wavecurve/io/drawings/detail/read_points.hpp"
#include "wavecurve/io/drawings/detail/svg/read_svg.hpp"
#include "wavecurve/io/files/detail/text.hpp"
#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve::io {

DrawingFile read_drawing(const std::filesystem::path& path) {
  const std::string ending = lower_case(path.extension().string());
  const auto refuse = [&](std::string_view defect) {
    throw std::invalid_argument(fmt::format("{}: {}", path.string(), defect));
  };
  if (ending != ".svg" && ending != ".csv") refuse("a drawing is read from .svg or .csv");
  const std::string bytes = read_file(path);
  if (bytes.empty()) refuse("the file is empty");
  try {
    return ending == ".svg" ? read_svg(bytes) : read_points(bytes);
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
  return {};
}

}  // namespace wavecurve::io
