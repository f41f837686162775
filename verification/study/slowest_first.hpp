#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "verification/study/study_point.hpp"

namespace wavecurve::verification {

/// The order in which several machines do the points of a study, so that none is left with a long
/// solve at the end. A cost model is fitted while the study runs, to one solver at one tolerance: the
/// mean of the seconds at each size, and between sizes a power of the size, by power_fit.hpp from three
/// sizes on, before that N. What nothing is known of comes first, large and fine before small and coarse.
class SlowestFirst {
 public:
  /// The open places of the points, which must outlive this.
  SlowestFirst(const std::vector<StudyPoint>& points, const std::vector<std::size_t>& open);

  /// The place of the point that is thought to be the slowest of those left, in the plan's order among
  /// equals; none if all are taken.
  std::optional<std::size_t> take();

  /// A point has been solved.
  void learn(const StudyPoint& point);

 private:
  using Sweep = std::pair<std::string, double>;  ///< a solver, a tolerance (0: none)
  struct Group {
    std::vector<std::size_t> left;  ///< places, the last to be taken first
    double seconds = 0;             ///< of the solved ones, together
    std::size_t solved = 0;
  };
  using Sizes = std::map<Eigen::Index, Group>;

  static Sweep sweep_of(const StudyPoint& point);
  static std::optional<double> expected_seconds(const Sizes& sizes, Eigen::Index size);

  std::map<Sweep, Sizes> groups_;
};

}  // namespace wavecurve::verification
