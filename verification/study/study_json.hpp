#pragma once

#include <string>
#include <vector>

#include "wavecurve/io/files/write_file.hpp"

#include "verification/study/study_plan.hpp"
#include "verification/study/study_summary.hpp"

namespace wavecurve::verification {

/// One point as one line, without a line feed:
///   {"solver", "filter", "samples", "levels", "shape", "damping": [s1, s2], "tolerance",
///    "error": {"displacement_l2_max", ...}, "energy_drift", "model_errors",
///    "cost": {"evaluations", "operations", "seconds"}, "status": "ok" | "failed", "reason",
///    "fingerprint"}
/// tolerance is null for a closed form, which alone has model_errors; error, energy_drift and cost
/// are null for a failed solve, which alone has a reason; the fingerprint has 16 hexadecimal digits.
/// Doubles are written so that they are read back exactly.
std::string to_json_line(const StudyPoint& point);

/// The inverse. Throws std::invalid_argument for what is no such line.
StudyPoint point_of_json_line(const std::string& line);

/// The file that says what a study is of: {"settings": [{"filter", "samples", "levels", "shape",
/// "damping": [s1, s2]}, ...], "solvers": [...]}.
std::string to_json(const StudyPlan& plan);

/// The inverse. Throws std::invalid_argument for what is no such document.
StudyPlan plan_of_json(const std::string& text);

/// {"points": [...], "floors": [...], "orders": [...], "growth": [...]}, indented.
void write_json(const std::vector<StudyPoint>& points, const StudySummary& summary,
                const io::TextSink& sink);

/// A line of column names, then a line for each point, fields as in RFC 4180.
void write_csv(const std::vector<StudyPoint>& points, const io::TextSink& sink);

}  // namespace wavecurve::verification
