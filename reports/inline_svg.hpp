#pragma once

#include <string>
#include <string_view>

namespace wavecurve::reports {

/// An SVG document made fit to stand inside an HTML page: without XML prolog and doctype, every id
/// and each reference to one prefixed with `prefix` (programs reuse theirs), and its own title and
/// description replaced by these, for screen readers. Throws std::invalid_argument if there is no
/// svg element.
std::string inline_svg(std::string_view document, const std::string& prefix,
                       const std::string& title, const std::string& description);

}  // namespace wavecurve::reports
