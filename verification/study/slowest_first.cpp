#include "verification/study/slowest_first.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "verification/study/power_fit.hpp"

namespace wavecurve::verification {

SlowestFirst::SlowestFirst(const std::vector<StudyPoint>& points,
                           const std::vector<std::size_t>& open) {
  for (auto place = open.rbegin(); place != open.rend(); ++place) {
    const StudyPoint& point = points[*place];
    groups_[sweep_of(point)][point.setting->samples].left.push_back(*place);
  }
}

SlowestFirst::Sweep SlowestFirst::sweep_of(const StudyPoint& point) {
  return {point.solver, point.tolerance.value_or(0)};
}

std::optional<double> SlowestFirst::expected_seconds(const Sizes& sizes, Eigen::Index size) {
  std::vector<double> samples, seconds;
  for (const auto& [of, group] : sizes) {
    if (group.solved == 0 || !(group.seconds > 0)) continue;
    const double mean = group.seconds / static_cast<double>(group.solved);
    if (of == size) return mean;
    samples.push_back(static_cast<double>(of));
    seconds.push_back(mean);
  }
  if (samples.empty()) return {};
  const double exponent = samples.size() < 3 ? 1 : fit_power(samples, seconds).exponent;
  return seconds.back() * std::pow(static_cast<double>(size) / samples.back(), exponent);
}

std::optional<std::size_t> SlowestFirst::take() {
  Group* slowest = nullptr;
  // Unknown before known, then by seconds, or by size and tolerance.
  std::tuple<bool, double, double> most;
  for (auto& [sweep, sizes] : groups_) {
    for (auto& [size, group] : sizes) {
      if (group.left.empty()) continue;
      const auto seconds = expected_seconds(sizes, size);
      const std::tuple cost(!seconds, seconds.value_or(static_cast<double>(size)),
                            seconds ? 0.0 : -sweep.second);
      if (slowest && cost <= most) continue;
      slowest = &group;
      most = cost;
    }
  }
  if (!slowest) return {};
  const std::size_t place = slowest->left.back();
  slowest->left.pop_back();
  return place;
}

void SlowestFirst::learn(const StudyPoint& point) {
  Group& group = groups_[sweep_of(point)][point.setting->samples];
  group.seconds += point.seconds;
  ++group.solved;
}

}  // namespace wavecurve::verification
