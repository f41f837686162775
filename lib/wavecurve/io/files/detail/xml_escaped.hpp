#pragma once

#include <string>
#include <string_view>

namespace wavecurve::io {

/// Text as XML or HTML has it, between tags or in a quoted attribute.
std::string xml_escaped(std::string_view text);

}  // namespace wavecurve::io
