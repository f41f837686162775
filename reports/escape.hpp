#pragma once

#include "wavecurve/io/files/detail/xml_escaped.hpp"

namespace wavecurve::reports {

/// What the pages call it.
inline std::string escape(std::string_view text) { return io::xml_escaped(text); }

}  // namespace wavecurve::reports
