#include "verification/routes/route_chance.hpp"

#include <algorithm>
#include <cmath>

namespace wavecurve::verification {

namespace {

double middle_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
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
  std::vector<double> exactly{1};  // of the events so far, k happen
  for (const double p : probabilities) {
    exactly.push_back(0);
    for (std::size_t k = exactly.size() - 1; k > 0; --k) {
      exactly[k] = exactly[k] * (1 - p) + exactly[k - 1] * p;
    }
    exactly[0] *= 1 - p;
  }
  double sum = 0;
  for (std::size_t k = exactly.size(); k-- > 0 && static_cast<int>(k) >= least;) sum += exactly[k];
  return std::min(1.0, std::max(sum, least_chance));
}

double ways_to_choose(int n, int k) {
  double ways = 1;
  for (int i = 1; i <= k; ++i) ways = ways * (n - k + i) / i;
  return std::round(ways);
}

}  // namespace wavecurve::verification
