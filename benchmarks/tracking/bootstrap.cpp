#include "benchmarks/tracking/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace wavecurve::tracking {

namespace {

std::vector<double> resample(const std::vector<double>& values, std::mt19937_64& random) {
  std::uniform_int_distribution<std::size_t> any(0, values.size() - 1);
  std::vector<double> sample(values.size());
  for (double& value : sample) value = values[any(random)];
  return sample;
}

/// Linear between the order statistics.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

/// The interval of a ratio, from estimates of its logarithm.
RatioInterval interval(double estimate, std::vector<double> resampled, double confidence) {
  std::ranges::sort(resampled);
  return {std::exp(estimate), std::exp(quantile(resampled, (1 - confidence) / 2)),
          std::exp(quantile(resampled, (1 + confidence) / 2))};
}

}  // namespace

double log_ratio(const Block& block) {
  return (std::log(block.b_first) + std::log(block.b_second) - std::log(block.a_first) -
          std::log(block.a_second)) /
         2;
}

double median(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("the median of 0 values: at least 1 is needed");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

RatioInterval bootstrap_ratio(const std::vector<Block>& blocks, double confidence,
                              std::uint64_t seed, int samples) {
  std::vector<double> ratios;
  for (const Block& block : blocks) ratios.push_back(log_ratio(block));
  const double estimate = median(ratios);
  std::mt19937_64 random(seed);
  std::vector<double> medians(static_cast<std::size_t>(samples));
  for (double& value : medians) value = median(resample(ratios, random));
  return interval(estimate, std::move(medians), confidence);
}

RatioInterval bootstrap_ratio(const std::vector<double>& a, const std::vector<double>& b,
                              double confidence, std::uint64_t seed, int samples) {
  const double estimate = std::log(median(b) / median(a));
  std::mt19937_64 random(seed);
  std::vector<double> ratios(static_cast<std::size_t>(samples));
  for (double& value : ratios) {
    value = std::log(median(resample(b, random)) / median(resample(a, random)));
  }
  return interval(estimate, std::move(ratios), confidence);
}

}  // namespace wavecurve::tracking
