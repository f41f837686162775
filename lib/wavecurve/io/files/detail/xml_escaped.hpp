#pragma once

#include <string>
#include <string_view>

namespace wavecurve::io {

/// Text as XML, HTML and SVG have it, between tags or in a quoted attribute. Control characters,
/// which none of them allows, become U+FFFD.
std::string xml_escaped(std::string_view text);

}  // namespace wavecurve::io
