#include "tools/commands/drawing_input.hpp"

#include <charconv>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"

#include "tools/commands/progress.hpp"

namespace wavecurve::tools {

Drawing drawing_of(const std::string& path) {
  io::DrawingFile file = io::read_drawing(path);
  for (const std::string& warning : file.warnings) {
    tell(fmt::format("wavecurve: {}: {}\n", path, warning));
  }
  return std::move(file.drawing);
}

std::optional<Eigen::Index> parsed_number(const std::string& text) {
  Eigen::Index number = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  if (error != std::errc() || end != last) return std::nullopt;
  return number;
}

std::optional<Eigen::Index> parsed_scale(const std::string& text) {
  if (text == "full") return std::nullopt;
  if (const auto number = parsed_number(text)) return number;
  throw std::invalid_argument(must_be("--scale", text, "a number of control points, or full"));
}

void check_sheet(bool is_sheet, const std::string& output) {
  if (!is_sheet || output.ends_with(".svg")) return;
  throw std::invalid_argument(must_be("the file of a sheet", output, "an .svg"));
}

}  // namespace wavecurve::tools
