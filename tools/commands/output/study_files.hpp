#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/study/study_plan.hpp"
#include "verification/study/study_summary.hpp"

namespace wavecurve::tools {

// In the folder of a study:
constexpr const char* journal_name = "compare.points.jsonl";  ///< its finished points
constexpr const char* plan_name = "compare.plan.json";        ///< what it is of

/// The plan, compare.json, compare.csv and the page of charts.
void write_study_files(const verification::StudyPlan& plan,
                       const std::vector<verification::StudyPoint>& points,
                       const verification::StudySummary& summary,
                       const std::filesystem::path& folder);

/// To the standard output: "text", "json" or "csv". The text names the page in the directory, or says
/// that there may be one.
void print_study(const std::vector<verification::StudyPoint>& points,
                 const verification::StudySummary& summary, const std::string& format,
                 const std::filesystem::path& directory);

}  // namespace wavecurve::tools
