#pragma once

#include <filesystem>
#include <string>

#include "wavecurve/motion/gait/model/gait_parameters.hpp"

namespace wavecurve::io {

/// The parameters of a gait as JSON, every number the shortest decimal that is read back as the
/// same double, null for what is not a number (a coefficient without gamma):
///   {"format": "wavecurve-gait", "version": 1, "period": 0.5, "facing": 1, "stride": 0.97,
///    "filter": "bspline4.4", "samples": 128, "scale": 32,
///    "limbs": [{"limb": "LF", "foot": 12, "offset": 0, "phases": [
///      {"phase": "stance", "share": 0.57, "x": [...], "y": [...], "model": "sextic",
///       "begin": 0, "end": 0.57, "parameters": [[...], ...]}, ...]}, ...],
///    "subcycles": [as limbs],
///    "gammas": [{"limb": "LF", "phase": "stance", "gamma": [...], "standard_error": [...],
///      "limb_gamma": 0.1, "limb_standard_error": 0.01, "level_gamma": [...],
///      "level_standard_error": [...]}, ...],
///    "quality": [{"limb": "LF", "phase": "swing", "model": "quadratic",
///      "residual_share_of_stride": 0.02, "cross_validated": 0.02,
///      "foot_share_of_excursion": 0.1, "cycles": 3}, ...]}
/// x and y are the control points of the key frame at which the phase begins; parameters one row a
/// line of PhaseMotion, the x of all control points before the y. Lengths are those of the tracks.
std::string gait_parameters_json(const gait::GaitParameters& parameters);

/// Reads them. Throws std::invalid_argument naming the file and the defect.
gait::GaitParameters read_gait_parameters(const std::filesystem::path& path);

}  // namespace wavecurve::io
