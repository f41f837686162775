#pragma once

#include <string_view>

namespace wavecurve::io {

/// Whether a name comes before another as a reader would sort them: letter by letter, but numbers
/// within by their value, so that frame-2 precedes frame-10. Names that differ in zeros before a
/// number only are equal.
bool naturally_precedes(std::string_view a, std::string_view b);

}  // namespace wavecurve::io
