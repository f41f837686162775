#pragma once

#include <string>

namespace wavecurve::reports {

/// The opening of a page in the style of the reports, up to and with </head>; the title is text.
std::string html_head(const std::string& title);

}  // namespace wavecurve::reports
