#include "verification/study/study_summary.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "wavecurve/elementary/logarithm.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"

#include "verification/study/named_shapes.hpp"

namespace wavecurve::verification {

namespace {

using Points = std::vector<const StudyPoint*>;

/// Errors below this are of rounding: some thousand steps, each of a few units of 2^-53.
constexpr double rounding = 1e-12;
/// Three points have an interval, but one so wide that it says nothing.
constexpr std::size_t fewest_points = 4;
constexpr double least_increase = 1.1, order_spread = 1.0 / 3;

double evaluations(const StudyPoint& point) { return static_cast<double>(point.cost.evaluations); }

/// The order between two neighbours.
double local_order(const StudyPoint& coarse, const StudyPoint& fine) {
  return logarithm(coarse.errors->displacement_l2_max / fine.errors->displacement_l2_max) /
         logarithm(evaluations(fine) / evaluations(coarse));
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// From fine to coarse, as long as errors grow and costs fall.
Points falling_part(const Points& sweep) {
  Points part;
  for (auto point = sweep.rbegin(); point != sweep.rend(); ++point) {
    if (!(*point)->errors) break;
    const double error = (*point)->errors->displacement_l2_max;
    if (part.empty() && error < rounding) continue;
    if (!part.empty() && (error <= part.back()->errors->displacement_l2_max ||
                          evaluations(*part.back()) < least_increase * evaluations(**point))) {
      break;
    }
    part.push_back(*point);
  }
  return part;
}

/// The asymptotic range, from coarse to fine.
Points asymptotic(const Points& sweep) {
  Points part = falling_part(sweep);
  std::vector<double> orders;
  for (std::size_t i = 1; i < part.size(); ++i)
    orders.push_back(local_order(*part[i], *part[i - 1]));
  if (orders.empty()) return {};
  const double typical = median(orders);
  std::size_t count = 1;
  while (count < part.size() && std::abs(orders[count - 1] - typical) <= order_spread * typical) {
    ++count;
  }
  part.resize(count);
  return {part.rbegin(), part.rend()};
}

void add_order(std::vector<ObservedOrder>& orders, const Points& sweep) {
  const Points part = asymptotic(sweep);
  if (part.size() < fewest_points) return;
  ObservedOrder order{part.front()->setting, part.front()->solver, {}, {}};
  std::vector<double> costs, errors;
  for (const StudyPoint* point : part) {
    order.tolerances.push_back(*point->tolerance);
    costs.push_back(1 / evaluations(*point));
    errors.push_back(point->errors->displacement_l2_max);
  }
  order.fit = fit_power(costs, errors);
  orders.push_back(std::move(order));
}

/// All levels of any size count as the same number.
StudySetting without_size(StudySetting setting) {
  if (setting.levels == all_levels(setting.samples)) setting.levels = -1;
  setting.samples = 0;
  return setting;
}

/// Points in groups that agree in what `key` says, in the order of their first.
template <class Key>
std::vector<Points> grouped(const Points& points, Key key) {
  std::vector<Points> groups;
  std::map<decltype(key(*points.front())), std::size_t> group_of_key;
  for (const StudyPoint* point : points) {
    const auto [found, is_new] = group_of_key.emplace(key(*point), groups.size());
    if (is_new) groups.emplace_back();
    groups[found->second].push_back(point);
  }
  return groups;
}

/// The costs of one solver at one tolerance, at several sizes.
std::optional<Growth> growth_of(const Points& points) {
  Growth growth{
      points.back()->setting, points.back()->solver, points.back()->tolerance, {}, {}, {}};
  std::vector<double> samples, operations, seconds;
  for (const StudyPoint* point : points) {
    if (!point->errors) return {};
    growth.samples.push_back(point->setting->samples);
    samples.push_back(static_cast<double>(point->setting->samples));
    operations.push_back(static_cast<double>(point->cost.operations));
    seconds.push_back(point->seconds);
  }
  if (samples.size() < 3) return {};
  growth.operations = fit_power(samples, operations);
  growth.seconds = fit_power(samples, seconds);
  return growth;
}

/// Adds the growth over all sizes of one solver: at the coarsest and the finest tolerance that none of them failed
/// at.
void add_growth(std::vector<Growth>& all, const Points& points) {
  std::vector<Growth> found;
  const auto tolerance = [](const StudyPoint& point) { return point.tolerance; };
  for (const Points& group : grouped(points, tolerance)) {
    if (auto growth = growth_of(group)) found.push_back(*std::move(growth));
  }
  if (found.empty()) return;
  all.push_back(found.front());
  if (found.size() > 1) all.push_back(found.back());
}

/// The orders of all sweeps; the points of a sweep stand together.
void add_orders(std::vector<ObservedOrder>& orders, const std::vector<StudyPoint>& points) {
  for (std::size_t first = 0, end = 0; first < points.size(); first = end) {
    Points sweep;
    for (; end < points.size() && points[end].solver == points[first].solver &&
           *points[end].setting == *points[first].setting;
         ++end) {
      sweep.push_back(&points[end]);
    }
    if (sweep.front()->tolerance) add_order(orders, sweep);
  }
}

bool has_three_sizes(const std::vector<StudyPoint>& points) {
  std::set<Eigen::Index> sizes;
  for (const StudyPoint& point : points) {
    sizes.insert(point.setting->samples);
    if (sizes.size() == 3) return true;
  }
  return false;
}

}  // namespace

StudySummary summarize(const std::vector<StudyPoint>& points) {
  StudySummary summary;
  for (const StudyPoint& point : points) {
    if (point.tolerance || !point.errors || point.solver == "spectral") continue;  // the reference
    summary.floors.push_back({point.setting, point.solver, point.errors->displacement_l2_max,
                              point.errors->energy_norm_max});
  }
  add_orders(summary.orders, points);
  if (!has_three_sizes(points)) return summary;
  Points all;
  for (const StudyPoint& point : points) all.push_back(&point);
  const auto sizes = [](const StudyPoint& p) {
    return std::pair(std::string_view(p.solver), without_size(*p.setting));
  };
  for (const Points& group : grouped(all, sizes)) add_growth(summary.growth, group);
  return summary;
}

std::vector<StudySetting> settings_of(const std::vector<StudyPoint>& points) {
  std::vector<StudySetting> settings;
  std::set<StudySetting> seen;
  const StudySetting* last = nullptr;
  for (const StudyPoint& point : points) {
    if (point.setting.get() == last) continue;
    last = point.setting.get();
    if (seen.insert(*last).second) settings.push_back(*last);
  }
  return settings;
}

std::string name_of(const StudySetting& setting) {
  return fmt::format("{}, {} samples, {} levels; {}, damping {}, {}", setting.filter,
                     setting.samples, setting.levels, setting.shape, setting.mass_damping,
                     setting.stiffness_damping);
}

}  // namespace wavecurve::verification
