#include "benchmarks/pages/history_series.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "benchmarks/tracking/bootstrap.hpp"
#include "benchmarks/tracking/change_points.hpp"
#include "benchmarks/tracking/timing.hpp"

namespace wavecurve::tracking {

double number(const Json& record, const std::vector<std::string>& keys) {
  const Json* place = &record;
  for (const std::string& key : keys) {
    const auto found = place->find(key);
    if (found == place->end()) return missing;
    place = &*found;
  }
  return place->is_number() ? place->get<double>() : missing;
}

TimesByName times_of(const Json& record) {
  TimesByName times;
  for (const Json& entry : record.value("benchmarks", Json::array())) {
    if (!entry.contains("cpu_time")) continue;
    std::vector<double> all = entry.at("cpu_time").get<std::vector<double>>();
    const double unit = seconds_of_unit(entry.at("time_unit").get<std::string>());
    for (double& time : all) time *= unit;
    times[entry.at("name").get<std::string>()] = {median(all), std::ranges::min(all),
                                                  std::ranges::max(all)};
  }
  return times;
}

std::vector<std::size_t> changes(const Series& series, double noise) {
  Series logs;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (!(series[i] > 0)) continue;
    logs.push_back(std::log(series[i]));
    places.push_back(i);
  }
  std::vector<std::size_t> result;
  for (const std::size_t i : change_points(logs, noise)) result.push_back(places[i]);
  return result;
}

std::string cell(double value) { return std::isnan(value) ? "?" : fmt::format("{:.4g}", value); }

std::string revision(const Json& record) {
  const Json revision = record.value("revision", Json::object());
  const std::string name = revision.value("commit", "?").substr(0, 8);
  return revision.value("is_dirty", false) ? name + "+" : name;
}

}  // namespace wavecurve::tracking
