#pragma once

#include <string>
#include <vector>

#include "verification/study/study_summary.hpp"

namespace wavecurve::tools {

/// The points of a study for a terminal: a table for each setting, with the floors of the models
/// and the observed orders beneath, then the growth of the costs.
std::string study_text(const std::vector<verification::StudyPoint>& points,
                       const verification::StudySummary& summary);

/// A line of column names, then a line for each point, fields as in RFC 4180.
std::string study_csv(const std::vector<verification::StudyPoint>& points);

}  // namespace wavecurve::tools
