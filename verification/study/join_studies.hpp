#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verification/study/solver_study.hpp"

namespace wavecurve::verification {

/// The points of one run, and what to call it.
struct NamedSource {
  std::string name;
  PointSource points;
};

struct JoinedStudy {
  std::vector<StudyPoint> points;  ///< those that are there, in the plan's order
  std::size_t missing = 0;
};

/// What the runs of several machines come to. If a point stands in a source more than once, the last
/// counts; one that stands in several sources must have the same results in all of them, but for
/// its seconds, of which the first stay. Points that the plan does not have are left out.
/// Throws std::invalid_argument naming the point, the sources and both errors if they disagree.
JoinedStudy join_studies(const StudyPlan& plan, const std::vector<NamedSource>& sources);

}  // namespace wavecurve::verification
