#include "tools/commands/input/drawing_input.hpp"

#include <cstdio>
#include <stdexcept>
#include <utility>

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

}  // namespace wavecurve::tools
