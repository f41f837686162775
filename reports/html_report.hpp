#pragma once

#include <string>

#include "reports/figures.hpp"
#include "reports/report.hpp"

namespace wavecurve::reports {

/// The report as one HTML page that needs nothing else: no network, no script, no font.
/// `figures` holds the SVG document of each chart and picture by its id; std::out_of_range if one
/// is missing.
std::string to_html(const Report& report, const Figures& figures);

}  // namespace wavecurve::reports
