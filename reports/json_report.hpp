#pragma once

#include <string>

#include "reports/report.hpp"

namespace wavecurve::reports {

/// report.json: publication, date, version, counts by verdict, and each claim with its values, words
/// and evidence. docs/report-json.md tells every field.
std::string to_json(const Report& report);

}  // namespace wavecurve::reports
