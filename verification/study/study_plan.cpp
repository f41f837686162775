#include "verification/study/study_plan.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve::verification {

Eigen::VectorXd study_times() { return Eigen::VectorXd::LinSpaced(41, 0, 1); }

std::vector<std::optional<double>> sweep(const dynamics::NamedSolver& solver) {
  switch (solver.accuracy) {
    case dynamics::AccuracyKind::tolerance:
      return {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
    case dynamics::AccuracyKind::step:
      return {1.0 / 64, 1.0 / 128, 1.0 / 256, 1.0 / 512, 1.0 / 1024, 1.0 / 2048};
    case dynamics::AccuracyKind::closed_form:
      break;
  }
  return {std::nullopt};
}

std::vector<StudyPoint> points_of(const StudyPlan& plan, const Shard& shard) {
  if (shard.index < 1 || shard.index > shard.count) {
    throw std::invalid_argument(
        fmt::format("shard {}/{}: must be one of 1 to {}", shard.index, shard.count, shard.count));
  }
  std::vector<StudyPoint> of_a_setting;
  for (const std::string& name : plan.solvers) {
    for (const auto& tolerance : sweep(dynamics::find_solver(name))) {
      StudyPoint& point = of_a_setting.emplace_back();
      point.solver = name;
      point.tolerance = tolerance;
    }
  }
  std::vector<StudyPoint> points;
  points.reserve(plan.settings.size() * of_a_setting.size() / shard.count + 1);
  std::size_t number = 0;
  for (const StudySetting& setting : plan.settings) {
    const auto shared = std::make_shared<const StudySetting>(setting);
    for (StudyPoint& point : of_a_setting) {
      if (number++ % shard.count + 1 != shard.index) continue;
      point.setting = shared;
      points.push_back(point);
    }
  }
  return points;
}

PlacesOfPoints::PlacesOfPoints(const std::vector<StudyPoint>& points) : points_(&points) {
  for (std::size_t first = 0, end = 0; first < points.size(); first = end) {
    while (end < points.size() && points[end].setting == points[first].setting) ++end;
    range_of_setting_.emplace(*points[first].setting, std::pair(first, end));
  }
}

std::optional<std::size_t> PlacesOfPoints::find(const StudyPoint& point) const {
  const auto found = range_of_setting_.find(*point.setting);
  if (found == range_of_setting_.end()) return {};
  for (std::size_t i = found->second.first; i < found->second.second; ++i) {
    const StudyPoint& here = (*points_)[i];
    if (here.tolerance == point.tolerance && here.solver == point.solver) return i;
  }
  return {};
}

}  // namespace wavecurve::verification
