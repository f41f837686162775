#pragma once

#include <string>
#include <vector>

#include "verification/study/solver_study.hpp"
#include "verification/study/study_summary.hpp"

namespace wavecurve::verification {

/// One point as one line, without a line feed:
///   {"solver", "filter", "samples", "levels", "shape", "damping": [s1, s2], "tolerance",
///    "error": {"displacement_l2_max", ...}, "energy_drift", "model_errors",
///    "cost": {"evaluations", "operations", "seconds"}, "status": "ok" | "failed", "reason",
///    "fingerprint"}
/// tolerance is null for a closed form, which alone has model_errors; error, energy_drift and cost
/// are null for a failed solve, which alone has a reason. Doubles are written so that they are read
/// back exactly.
std::string to_json_line(const StudyPoint& point);

/// The inverse. Throws std::invalid_argument for what is no such line.
StudyPoint point_of_json_line(const std::string& line);

/// {"points": [...], "floors": [...], "orders": [...], "growth": [...]}, indented.
std::string to_json(const std::vector<StudyPoint>& points, const StudySummary& summary);

}  // namespace wavecurve::verification
