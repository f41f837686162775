#include "example_drawing.hpp"

#include <filesystem>

#include "wavecurve/io/read_drawing.hpp"

namespace wavecurve::verification {

Drawing example_drawing(std::string_view file_name) {
  return io::read_drawing(std::filesystem::path(WAVECURVE_EXAMPLES_DIR) / file_name).drawing;
}

}  // namespace wavecurve::verification
