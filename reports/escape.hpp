#pragma once

#include <string>
#include <string_view>

namespace wavecurve::reports {

/// Text made fit for HTML and SVG, between tags as well as within quoted attributes. Control
/// characters, which neither allows, become U+FFFD.
std::string escape(std::string_view text);

}  // namespace wavecurve::reports
