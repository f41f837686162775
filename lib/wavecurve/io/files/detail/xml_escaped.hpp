#pragma once

#include <string>
#include <string_view>

namespace wavecurve::io {

/// Text as XML, HTML and SVG have it, between tags or in a quoted attribute. Control characters but
/// tab and line feed, which not all of them allow, and what is no UTF-8 become U+FFFD.
std::string xml_escaped(std::string_view text);

}  // namespace wavecurve::io
