#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/report.hpp"

namespace wavecurve::reports {

/// One line a claim (id, verdict, finding), then the counts by verdict. Lines are cut to `width`
/// columns; 0 means that they are not cut.
std::string terminal_table(const std::vector<verification::ClaimResult>& results,
                           std::size_t width);

}  // namespace wavecurve::reports
