#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wavecurve/dynamics/solver.hpp"

#include "verification/study/study_point.hpp"

namespace wavecurve::verification {

/// The product of all lists.
struct StudyPlan {
  std::vector<StudySetting> settings;
  std::vector<std::string> solvers;

  friend bool operator==(const StudyPlan&, const StudyPlan&) = default;
};

/// Every count-th point of a plan, from the index-th on, 1 <= index <= count: what one of `count`
/// machines does.
struct Shard {
  std::size_t index = 1, count = 1;
};

/// The times of StudyPoint::model_errors.
Eigen::VectorXd study_times();

/// The accuracies that a solver is swept over, from coarse to fine; one empty of a closed form.
std::vector<std::optional<double>> sweep(const dynamics::NamedSolver& solver);

/// The points of the shard in the plan's order: setting by setting, solver by solver, from coarse to
/// fine. They have no results. Throws std::invalid_argument for an unknown solver, or an index that is
/// not one of 1 .. count.
std::vector<StudyPoint> points_of(const StudyPlan& plan, const Shard& shard = {});

/// Finds points by what they are the results of.
class PlacesOfPoints {
 public:
  /// Those of one setting must stand together. They must outlive this.
  explicit PlacesOfPoints(const std::vector<StudyPoint>& points);

  /// The place of the point of the same setting, solver and tolerance.
  std::optional<std::size_t> find(const StudyPoint& point) const;

 private:
  const std::vector<StudyPoint>* points_;
  std::map<StudySetting, std::pair<std::size_t, std::size_t>> range_of_setting_;
};

}  // namespace wavecurve::verification
