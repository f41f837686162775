#pragma once

#include <string_view>

#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::verification {

/// A drawing of docs/examples.
Drawing example_drawing(std::string_view file_name);

}  // namespace wavecurve::verification
