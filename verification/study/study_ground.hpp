#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "wavecurve/dynamics/initial_value_problem.hpp"

#include "verification/study/study_point.hpp"

namespace wavecurve::verification {

/// What all points of a setting stand on.
struct StudyGround {
  dynamics::InitialValueProblem problem;
  dynamics::Trajectory exact;
};

/// The grounds of many settings. They are large: each is made when a point asks for it, and the last
/// few are kept. For several threads at once.
class StudyGrounds {
 public:
  /// Makes the problem of each setting once and keeps its fingerprint: FNV-1a over the bits of the
  /// numbers that it consists of.
  /// Throws std::invalid_argument for an unknown filter or shape, sizes that do not fit, or a shape
  /// that is the circle, std::domain_error for a filter that is not smooth enough.
  explicit StudyGrounds(std::vector<std::shared_ptr<const StudySetting>> settings);

  /// The fingerprint of the setting at that place.
  std::uint64_t fingerprint(std::size_t setting) const { return fingerprints_[setting]; }

  /// The ground of a setting. Throws std::runtime_error if the setting names a file that has become
  /// another one since.
  std::shared_ptr<const StudyGround> take(std::size_t setting);

 private:
  struct Slot {
    std::mutex making;
    std::shared_ptr<const StudyGround> ground;
  };

  std::shared_ptr<Slot> slot_of(std::size_t setting);
  std::shared_ptr<const StudyGround> made(std::size_t setting) const;

  std::vector<std::shared_ptr<const StudySetting>> settings_;
  std::vector<std::uint64_t> fingerprints_;
  std::mutex access_;
  std::list<std::pair<std::size_t, std::shared_ptr<Slot>>> slots_;  ///< the last used first
};

}  // namespace wavecurve::verification
