#pragma once

#include <string>
#include <vector>

#include "benchmarks/tracking/record.hpp"
#include "reports/page.hpp"

namespace wavecurve::tracking {

/// The records in the order of time, as a page: for each marked kernel its time beside its physical
/// limits, its instructions, and where either changed (change_points); every accuracy; and the
/// times of all other benchmarks. Throws std::invalid_argument where there is no record.
reports::Page history_page(const std::vector<Json>& history);

}  // namespace wavecurve::tracking
