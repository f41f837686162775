#include "tools/commands/input/drawing_input.hpp"

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

#include "tools/commands/input/number_option.hpp"
#include "tools/commands/terminal.hpp"

namespace wavecurve::tools {

Drawing drawing_of(const std::string& path, const io::PointOptions& options) {
  io::DrawingFile file = io::read_drawing(path, options);
  for (const std::string& warning : file.warnings) {
    print_message(path + ": " + warning);
  }
  return std::move(file.drawing);
}

void add_point_options(CLI::App* command, io::PointOptions& options) {
  command->add_flag("--open", options.open, "The points of a table (.csv) are open lines");
  command->add_flag("--y-up", options.y_up, "In a table of points, y points up");
}

std::optional<Eigen::Index> parsed_scale(const std::string& text) {
  if (text == "full") return std::nullopt;
  if (const auto number = parsed_whole_number(text)) return number;
  throw std::invalid_argument(must_be("--scale", text, "a number of control points, or full"));
}

void check_sheet(bool is_sheet, const std::string& output) {
  if (!is_sheet || output.ends_with(".svg")) return;
  throw std::invalid_argument(must_be("the file of a sheet", output, "an .svg"));
}

void check_tolerance(double tolerance, const std::string& output) {
  const std::string ending = std::filesystem::path(output).extension().string();
  const bool holds_curves = ending == ".svg" || ending == ".json" || ending == ".html";
  if (tolerance == 0 || holds_curves) return;
  throw std::invalid_argument(fmt::format(
      "--tolerance is for .svg, .json and .html, which hold curves, not for {}", ending));
}

}  // namespace wavecurve::tools
