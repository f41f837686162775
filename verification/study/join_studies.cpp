#include "verification/study/join_studies.hpp"

#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace wavecurve::verification {

namespace {

constexpr std::uint32_t nobody = 0;

bool is_same_result(const StudyPoint& a, const StudyPoint& b) {
  return a.fingerprint == b.fingerprint && a.errors == b.errors && a.cost == b.cost &&
         a.model_errors == b.model_errors && a.failure == b.failure;
}

std::string result_of(const StudyPoint& point) {
  if (!point.errors) return "failed: " + point.failure;
  return fmt::format("an L2 error of {} and {} evaluations", point.errors->displacement_l2_max,
                     point.cost.evaluations);
}

[[noreturn]] void fail(const StudyPoint& one, const std::string& name, const StudyPoint& other,
                       const std::string& other_name) {
  const bool same_numbers = one.fingerprint == other.fingerprint;
  throw std::invalid_argument(fmt::format(
      "{} and {} disagree about {}: {}", name, other_name, name_of(one),
      same_numbers ? fmt::format("{}; {}", result_of(one), result_of(other))
                   : "its filter or its shape was another file's at the one than at the other"));
}

}  // namespace

JoinedStudy join_studies(const StudyPlan& plan, const std::vector<NamedSource>& sources) {
  std::vector<StudyPoint> points = points_of(plan);
  const PlacesOfPoints places(points);
  std::vector<std::uint32_t> source_of_point(points.size(), nobody);
  for (std::uint32_t source = 1; source <= sources.size(); ++source) {
    std::map<std::size_t, StudyPoint> again;
    sources[source - 1].points([&](StudyPoint point) {
      const auto place = places.find(point);
      if (!place) return;
      std::uint32_t& owner = source_of_point[*place];
      if (owner == nobody) owner = source;
      point.setting = points[*place].setting;
      (owner == source ? points[*place] : again[*place]) = std::move(point);
    });
    for (const auto& [place, point] : again) {
      if (is_same_result(points[place], point)) continue;
      fail(points[place], sources[source_of_point[place] - 1].name, point,
           sources[source - 1].name);
    }
  }
  JoinedStudy joined;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (source_of_point[i] == nobody) {
      ++joined.missing;
    } else {
      joined.points.push_back(std::move(points[i]));
    }
  }
  return joined;
}

}  // namespace wavecurve::verification
