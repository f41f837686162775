#include "benchmarks/tracking/change_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "benchmarks/tracking/bootstrap.hpp"

namespace wavecurve::tracking {

namespace {

double noise_of(const std::vector<double>& values, double least) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    steps.push_back(std::abs(values[i] - values[i - 1]));
  }
  // For normal noise the median of magnitudes is 1 / 1.4826 standard deviations.
  return std::max(least, 1.4826 / std::numbers::sqrt2 * median(std::move(steps)));
}

/// Sums of values and of squares up to each index, from which the cost of any segment follows.
class Segments {
 public:
  explicit Segments(const std::vector<double>& values) : sums_{0}, squares_{0} {
    for (const double value : values) {
      // About the first value, so that nothing cancels.
      const double v = value - values.front();
      sums_.push_back(sums_.back() + v);
      squares_.push_back(squares_.back() + v * v);
    }
  }
  /// Squares about the mean of the values first .. end - 1.
  double cost(std::size_t first, std::size_t end) const {
    const double sum = sums_[end] - sums_[first];
    return squares_[end] - squares_[first] - sum * sum / static_cast<double>(end - first);
  }

 private:
  std::vector<double> sums_, squares_;
};

}  // namespace

std::vector<std::size_t> change_points(const std::vector<double>& values, double least_noise) {
  const std::size_t n = values.size();
  if (n < 3) return {};
  const double noise = noise_of(values, least_noise);
  const double penalty = 3 * std::log(static_cast<double>(n)) * noise * noise;
  const Segments segments(values);
  std::vector<double> best(n + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> start(n + 1, 0);
  best[0] = -penalty;
  for (std::size_t end = 1; end <= n; ++end) {
    for (std::size_t first = 0; first < end; ++first) {
      const double cost = best[first] + segments.cost(first, end) + penalty;
      if (cost < best[end]) {
        best[end] = cost;
        start[end] = first;
      }
    }
  }
  std::vector<std::size_t> changes;
  for (std::size_t end = n; start[end] > 0; end = start[end]) changes.push_back(start[end]);
  std::ranges::reverse(changes);
  return changes;
}

}  // namespace wavecurve::tracking
