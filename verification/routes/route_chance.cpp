#include "verification/routes/route_chance.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace wavecurve::verification {

namespace {

double middle_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The probability that at most so many of the events do not happen.
double chance_of_few_misses(std::size_t most, const std::vector<double>& probabilities) {
  std::vector<double> exactly(most + 1, 0.0);  // of the events so far, k do not happen
  exactly[0] = 1;
  for (const double p : probabilities) {
    for (std::size_t k = most; k > 0; --k) exactly[k] = exactly[k] * p + exactly[k - 1] * (1 - p);
    exactly[0] *= p;
  }
  double sum = 0;
  for (std::size_t k = exactly.size(); k-- > 0;) sum += exactly[k];
  return sum;
}

/// Hoeffding's bound on the probability that at least so many of n events happen, whose mean
/// probability is p: exp(-n D), D = q ln(q/p) + (1 - q) ln((1 - q)/(1 - p)), q = needed / n > p.
double hoeffding_bound(double needed, const std::vector<double>& probabilities) {
  const auto n = static_cast<double>(probabilities.size());
  const double p = std::accumulate(probabilities.begin(), probabilities.end(), 0.0) / n;
  const double q = needed / n;
  if (q <= p) return 1;
  const double rest = q < 1 ? (1 - q) * std::log((1 - q) / (1 - p)) : 0;
  return std::exp(-n * (q * std::log(q / p) + rest));
}

}  // namespace

std::vector<double> chance_of_each(std::span<const EntryError> entries) {
  std::vector<double> in_units, absolute, relative;
  for (const EntryError& entry : entries) {
    if (entry.distance == 0) continue;
    in_units.push_back(entry.distance);
    absolute.push_back(entry.distance * entry.unit);
    if (entry.magnitude > 0) relative.push_back(absolute.back() / entry.magnitude);
  }
  const double units = 2 * middle_of(in_units), error = 2 * middle_of(absolute);
  const double relative_error = 2 * middle_of(relative);
  std::vector<double> result;
  for (const EntryError& entry : entries) {
    const double typical =
        std::min({units, error / entry.unit, relative_error * entry.magnitude / entry.unit});
    const double range = std::max(entry.distance, typical);
    const bool says_nothing = entry.distance == 0;
    result.push_back(says_nothing ? 1 : std::min(1.0, (1 + 2 * entry.allowance) / (2 * range)));
  }
  return result;
}

double chance_of_at_least(int least, std::span<const double> probabilities) {
  std::vector<double> open;  // what happens surely needs no arithmetic
  std::ranges::copy_if(probabilities, std::back_inserter(open), [](double p) { return p < 1; });
  const auto sure = static_cast<long>(probabilities.size() - open.size());
  const auto needed = static_cast<double>(least - sure), count = static_cast<double>(open.size());
  if (needed <= 0) return 1;
  if (needed > count) return least_chance;
  const double most_misses = count - needed;
  constexpr double most_steps = 4e6;
  const double chance = count * (most_misses + 1) > most_steps
                            ? hoeffding_bound(needed, open)
                            : chance_of_few_misses(static_cast<std::size_t>(most_misses), open);
  return std::clamp(chance, least_chance, 1.0);
}

double ways_to_choose(int n, int k) {
  double ways = 1;
  for (int i = 1; i <= k; ++i) ways = ways * (n - k + i) / i;
  return std::round(ways);
}

}  // namespace wavecurve::verification
