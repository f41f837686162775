#pragma once

#include <map>
#include <string>

namespace wavecurve::reports {

/// The SVG document of each figure of a page, by the figure's id.
using Figures = std::map<std::string, std::string>;

}  // namespace wavecurve::reports
