#pragma once

#include <string>
#include <vector>

#include "benchmarks/pages/limit_reasons.hpp"
#include "benchmarks/tracking/record.hpp"
#include "reports/page.hpp"

namespace wavecurve::tracking {

/// The records in the order of time, as a page: for each marked kernel its time beside its physical
/// limits, its instructions, and where either changed (change_points); every accuracy; and the
/// times of all other benchmarks. Kernels far from their limit are shown with the reason, if one is
/// given. Throws std::invalid_argument where there is no record.
reports::Page history_page(const std::vector<Json>& history, const LimitReasons& reasons = {});

}  // namespace wavecurve::tracking
