#include "verification/stand_ins/example_drawing.hpp"

#include <filesystem>

#include "wavecurve/io/drawings/read_drawing.hpp"

namespace wavecurve::verification {

Drawing example_drawing(std::string_view file_name) {
  return io::read_drawing(std::filesystem::path(WAVECURVE_EXAMPLES_DIR) / file_name).drawing;
}

}  // namespace wavecurve::verification
