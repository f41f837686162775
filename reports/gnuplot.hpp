#pragma once

#include <filesystem>

#include "verification/suite/claim.hpp"

namespace wavecurve::reports {

/// Draws a chart with the program gnuplot. ID.gp (script), ID.dat (data) and ID.svg are left in the
/// directory, so that `gnuplot ID.gp` there draws it anew.
/// Throws std::system_error if gnuplot cannot be started, naming its Debian package, and
/// std::runtime_error with the first line of its complaint if it fails.
void draw_chart(const verification::Chart& chart, const std::filesystem::path& directory);

}  // namespace wavecurve::reports
