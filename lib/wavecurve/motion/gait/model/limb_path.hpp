#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/motion/gait/model/phase_motion.hpp"

namespace wavecurve::gait {

/// A part of the cycle of a limb, between two key frames.
struct PathSpan {
  std::string phase;   ///< stance, swing; or a subcycle: A, B, C, D
  double share = 0;    ///< of the cycle
  Contour start;       ///< the control points at its beginning
  PhaseMotion motion;  ///< to the start of the next span
};

/// The closed path of a limb's control points through a cycle: it is continuous, and closes, since
/// a span ends where the next, after the last the first, starts.
struct LimbPath {
  std::string limb;
  Eigen::Index foot = 0;        ///< the control point that stands on the ground
  double offset = 0;            ///< the share of the cycle at which the first span begins
  std::vector<PathSpan> spans;  ///< shares sum up to 1
};

/// The path of one of its control points.
LimbPath path_of_point(const LimbPath& path, Eigen::Index point);

enum class Continuity {
  position,  ///< C0, as the models are
  velocity,  ///< C1: at each seam both spans get the mean of their velocities, by cubic terms
};

/// The control points at a share u of the cycle, any real number.
Contour pose_at(const LimbPath& path, double u, Continuity continuity = Continuity::position);

}  // namespace wavecurve::gait
