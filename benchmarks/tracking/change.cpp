#include "benchmarks/tracking/change.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace wavecurve::tracking {

std::string_view to_string(Change verdict) {
  constexpr std::array<std::string_view, 4> names{"faster", "slower", "same", "inconclusive"};
  return names[static_cast<std::size_t>(verdict)];
}

Change judge_time(const RatioInterval& ratio, double threshold) {
  const double slow = 1 + threshold, fast = 1 / slow;
  if (ratio.lower > 1 && ratio.ratio >= slow) return Change::slower;
  if (ratio.upper < 1 && ratio.ratio <= fast) return Change::faster;
  return ratio.lower > fast && ratio.upper < slow ? Change::same : Change::inconclusive;
}

Change judge_count(double before, double after, double threshold) {
  if (before == after) return Change::same;
  constexpr double resolution = 1e-4;
  const double ratio = std::round(after / before / resolution) * resolution;
  // Half a unit less: 1.01 is not a double.
  if (ratio >= 1 + threshold - resolution / 2) return Change::slower;
  return ratio <= 1 / (1 + threshold) + resolution / 2 ? Change::faster : Change::same;
}

Change judge_accuracy(const std::string& kind, double before, double after,
                      const Thresholds& thresholds) {
  if (kind == "iterations") return judge_count(before, after, thresholds.count);
  if (kind == "digits") {
    const double allowed = std::log10(1 + thresholds.accuracy);
    // Also where one of the two is no number.
    if (!(before - after < allowed)) return Change::slower;
    return after - before >= allowed ? Change::faster : Change::same;
  }
  if (kind != "error") {
    throw std::invalid_argument("accuracy of kind '" + kind +
                                "': error, iterations and digits are known");
  }
  if (before == after) return Change::same;
  // From zero, or to what is no number, no ratio tells anything: any loss is one.
  if (!(after <= before * (1 + thresholds.accuracy))) return Change::slower;
  return after <= before / (1 + thresholds.accuracy) ? Change::faster : Change::same;
}

}  // namespace wavecurve::tracking
