#pragma once

#include <string>
#include <vector>

#include "verification/study/study_summary.hpp"

namespace wavecurve::tools {

/// The points of a study for a terminal: a table for each setting, with the floors of the models
/// and the observed orders beneath, then the growth of the costs. Where there are too many settings
/// for that (study_overview.hpp): the solvers' errors over all of them, the best, and the worst.
std::string study_text(const std::vector<verification::StudyPoint>& points,
                       const verification::StudySummary& summary);

}  // namespace wavecurve::tools
