#pragma once

#include <filesystem>

#include "reports/report.hpp"

namespace wavecurve::reports {

/// Writes index.html, report.json and figures/ (for each chart its script, data and picture; for
/// each picture its SVG) into the directory, which is made if need be.
/// Throws std::logic_error for a figure id that is no file name or is used twice, and what
/// draw_chart and io::write_file throw.
void write_report(const Report& report, const std::filesystem::path& directory);

}  // namespace wavecurve::reports
