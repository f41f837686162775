#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "verification/study/study_plan.hpp"

namespace wavecurve::verification {

/// Gives one point after the other to `take`.
using PointSource = std::function<void(const std::function<void(StudyPoint)>& take)>;

/// What a run takes up and tells.
struct StudyHooks {
  /// Points of an earlier run: those that the plan asks for, of the same fingerprint, are not
  /// computed again. If there are several of one kind, the last is taken.
  PointSource known;
  /// Called with each computed point as soon as it is there, never by two threads at once.
  std::function<void(const StudyPoint&)> finished;
  /// Called with the numbers of points that are there and of all, never by two threads at once.
  std::function<void(std::size_t, std::size_t)> progress;
  /// Fills in the results of a point in the place of its solver, from several threads at once: what a
  /// test does that is about all else.
  std::function<void(StudyPoint&)> stand_in;
};

/// All points of the shard, in the order of points_of(), computed on all cores.
/// What a solver throws becomes its point's failure, unless the machine lacked something
/// (std::bad_alloc, std::system_error): such a point is not finished, all others are, and then
/// std::runtime_error names it. Throws std::invalid_argument for an unknown solver, filter or shape,
/// sizes that do not fit, or a shape that is the circle, before anything is computed; what a hook
/// throws ends the run.
std::vector<StudyPoint> run_study(const StudyPlan& plan, const StudyHooks& hooks = {},
                                  const Shard& shard = {});

}  // namespace wavecurve::verification
