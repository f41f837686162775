#include "verification/stand_ins/example_drawing.hpp"

#include "wavecurve/io/drawings/read_drawing.hpp"

#include "verification/suite/data_folder.hpp"

namespace wavecurve::verification {

Drawing example_drawing(std::string_view file_name) {
  return io::read_drawing(data_folder() / "examples" / file_name).drawing;
}

}  // namespace wavecurve::verification
