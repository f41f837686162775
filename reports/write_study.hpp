#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/study/study_summary.hpp"

namespace wavecurve::reports {

/// "How accurate is decoupling?": a sentence on each model, the span of its floors and in which
/// settings they are small, and one on the least error of the solvers with steps.
std::vector<std::string> answer(const std::vector<verification::StudyPoint>& points,
                                const verification::StudySummary& summary);

/// Writes index.html and figures/ into the directory, which is made if need be: charts and tables
/// of a study. Throws what draw_chart and io::write_file throw.
void write_study(const std::vector<verification::StudyPoint>& points,
                 const verification::StudySummary& summary, const std::filesystem::path& directory);

}  // namespace wavecurve::reports
