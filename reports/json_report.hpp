#pragma once

#include <string>

#include "reports/report.hpp"

namespace wavecurve::reports {

/// report.json: publication, date, version, counts by verdict, and each claim with its evidence.
std::string to_json(const Report& report);

}  // namespace wavecurve::reports
