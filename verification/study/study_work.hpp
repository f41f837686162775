#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "verification/study/solver_study.hpp"
#include "verification/study/study_ground.hpp"

namespace wavecurve::verification {

/// The points of a shard of a plan, some of them known, the others to be solved, one after the other or
/// side by side, by whoever runs the study.
class StudyWork {
 public:
  /// Throws as run_study() does before anything is computed.
  StudyWork(const StudyPlan& plan, const Shard& shard);

  /// Takes up what is known of the plan's points, of the same fingerprint.
  void take_up(const PointSource& known);

  /// The places of the points that are not known.
  std::vector<std::size_t> open() const;

  /// Fills in the result of a point, from several threads at once. What the machine lacked is no
  /// result: that is returned, empty if nothing was lacking. Throws std::runtime_error if a file has
  /// changed since the run began.
  std::string solve(std::size_t place, const StudyHooks& hooks);

  std::vector<StudyPoint>& points() { return points_; }

 private:
  std::vector<std::shared_ptr<const StudySetting>> settings();

  std::vector<StudyPoint> points_;
  std::vector<std::uint32_t> setting_of_point_;
  std::vector<bool> is_known_;
  StudyGrounds grounds_;
};

/// What is thrown at the end of a run in which the machine lacked something at `count` points.
[[noreturn]] void fail_for_lack(const StudyPoint& first, const std::string& what,
                                std::size_t count);

}  // namespace wavecurve::verification
