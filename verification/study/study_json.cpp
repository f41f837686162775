#include "verification/study/study_json.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/json_place.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"

namespace wavecurve::verification {

namespace {

using Json = nlohmann::ordered_json;
using Place = io::OrderedJsonPlace;

constexpr std::array<std::pair<const char*, double StudyErrors::*>, 8> error_names = {{
    {"displacement_l2_max", &StudyErrors::displacement_l2_max},
    {"displacement_l2_final", &StudyErrors::displacement_l2_final},
    {"maximum_norm_max", &StudyErrors::maximum_norm_max},
    {"maximum_norm_final", &StudyErrors::maximum_norm_final},
    {"velocity_l2_max", &StudyErrors::velocity_l2_max},
    {"velocity_l2_final", &StudyErrors::velocity_l2_final},
    {"energy_norm_max", &StudyErrors::energy_norm_max},
    {"energy_norm_final", &StudyErrors::energy_norm_final},
}};

Json json_of(const std::string& solver, const StudySetting& setting) {
  return {
      {"solver", solver},           {"filter", setting.filter},
      {"samples", setting.samples}, {"levels", setting.levels},
      {"shape", setting.shape},     {"damping", {setting.mass_damping, setting.stiffness_damping}}};
}

Json json_of(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

Json json_of(const StudyPoint& point) {
  Json json = json_of(point.solver, point.setting);
  json["tolerance"] = json_of(point.tolerance);
  json["error"] = json["energy_drift"] = json["cost"] = nullptr;
  if (point.errors) {
    json["error"] = Json::object();
    for (const auto& [name, member] : error_names) json["error"][name] = (*point.errors).*member;
    json["energy_drift"] = point.errors->energy_drift;
    json["cost"] = {{"evaluations", point.cost.evaluations},
                    {"operations", point.cost.operations},
                    {"seconds", point.seconds}};
  }
  if (!point.model_errors.empty()) json["model_errors"] = point.model_errors;
  json["status"] = point.failure.empty() ? "ok" : "failed";
  if (!point.failure.empty()) json["reason"] = point.failure;
  json["fingerprint"] = point.fingerprint;
  return json;
}

Json json_of(const PowerFit& fit) {
  return {{"exponent", fit.exponent}, {"interval_95", {fit.low, fit.high}}};
}

Json json_of(const ErrorFloor& floor) {
  Json json = json_of(floor.solver, floor.setting);
  json["displacement_l2_max"] = floor.displacement_l2_max;
  json["energy_norm_max"] = floor.energy_norm_max;
  json["cause"] = "model";
  return json;
}

Json json_of(const ObservedOrder& order) {
  Json json = json_of(order.solver, order.setting);
  json["tolerances"] = order.tolerances;
  json["order"] = json_of(order.fit);
  return json;
}

Json json_of(const Growth& growth) {
  Json json = json_of(growth.solver, growth.setting);
  json["samples"] = growth.samples;
  json["tolerance"] = json_of(growth.tolerance);
  json["operations"] = json_of(growth.operations);
  json["seconds"] = json_of(growth.seconds);
  return json;
}

template <class T>
Json json_of(const std::vector<T>& items) {
  Json json = Json::array();
  for (const T& item : items) json.push_back(json_of(item));
  return json;
}

StudyErrors errors_of(const Place& place) {
  StudyErrors errors;
  for (const auto& [name, member] : error_names) {
    errors.*member = place.at("error").at(name).number();
  }
  errors.energy_drift = place.at("energy_drift").number();
  return errors;
}

std::vector<double> numbers_of(const Place& place) {
  std::vector<double> numbers;
  for (const Place& element : place.elements()) numbers.push_back(element.number());
  return numbers;
}

/// A count, which is kept as a whole number or as a double.
long long count_of(const Place& place) {
  constexpr double most = 9007199254740992;  // 2^53
  const double count = place.number();
  if (!(count >= 0 && count <= most && count == std::trunc(count))) {
    place.refuse("a whole number from 0 to 2^53");
  }
  return static_cast<long long>(count);
}

StudySetting setting_of(const Place& place) {
  constexpr int most_samples = 1 << 20, most_levels = 20;
  const std::vector<double> damping = numbers_of(place.at("damping"));
  if (damping.size() != 2) place.at("damping").refuse("a list of two numbers");
  return {place.at("filter").text(),
          place.at("samples").whole_number(1, most_samples),
          place.at("levels").whole_number(0, most_levels),
          place.at("shape").text(),
          damping[0],
          damping[1]};
}

StudyPoint point_of(const Place& place) {
  StudyPoint point;
  point.setting = setting_of(place);
  point.solver = place.at("solver").text();
  const Place tolerance = place.at("tolerance");
  if (!tolerance.value().is_null()) point.tolerance = tolerance.number();
  point.fingerprint = place.at("fingerprint").text();
  if (place.at("status").text() == "failed") {
    point.failure = place.at("reason").text();
    return point;
  }
  point.errors = errors_of(place);
  if (const auto errors = place.find("model_errors")) point.model_errors = numbers_of(*errors);
  const Place cost = place.at("cost");
  point.cost = {count_of(cost.at("evaluations")), count_of(cost.at("operations"))};
  point.seconds = cost.at("seconds").number();
  return point;
}

}  // namespace

std::string to_json_line(const StudyPoint& point) { return io::json_text(json_of(point)); }

StudyPoint point_of_json_line(const std::string& line) {
  try {
    const Json document = io::parse_ordered_json(line);
    return point_of(Place(document));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("no point of a study: ") + error.what());
  }
}

std::string to_json(const std::vector<StudyPoint>& points, const StudySummary& summary) {
  const Json json = {{"points", json_of(points)},
                     {"floors", json_of(summary.floors)},
                     {"orders", json_of(summary.orders)},
                     {"growth", json_of(summary.growth)}};
  return io::json_text(json, 2) + "\n";
}

}  // namespace wavecurve::verification
