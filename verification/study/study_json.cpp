#include "verification/study/study_json.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/parse_json.hpp"

namespace wavecurve::verification {

namespace {

using Json = nlohmann::ordered_json;

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

StudyErrors errors_of(const Json& json) {
  StudyErrors errors;
  for (const auto& [name, member] : error_names) errors.*member = json.at("error").at(name);
  errors.energy_drift = json.at("energy_drift");
  return errors;
}

StudyPoint point_of(const Json& json) {
  StudyPoint point;
  point.setting = {json.at("filter"), json.at("samples"),       json.at("levels"),
                   json.at("shape"),  json.at("damping").at(0), json.at("damping").at(1)};
  point.solver = json.at("solver");
  if (!json.at("tolerance").is_null()) point.tolerance = json.at("tolerance").get<double>();
  point.fingerprint = json.at("fingerprint");
  if (json.at("status") == "failed") {
    point.failure = json.at("reason");
    return point;
  }
  point.errors = errors_of(json);
  if (json.contains("model_errors")) {
    point.model_errors = json["model_errors"].get<std::vector<double>>();
  }
  point.cost = {json.at("cost").at("evaluations"), json.at("cost").at("operations")};
  point.seconds = json.at("cost").at("seconds");
  return point;
}

}  // namespace

std::string to_json_line(const StudyPoint& point) {
  return json_of(point).dump(-1, ' ', false, Json::error_handler_t::replace);
}

StudyPoint point_of_json_line(const std::string& line) {
  try {
    return point_of(io::parse_ordered_json(line));
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(std::string("no point of a study: ") + error.what());
  }
}

std::string to_json(const std::vector<StudyPoint>& points, const StudySummary& summary) {
  const Json json = {{"points", json_of(points)},
                     {"floors", json_of(summary.floors)},
                     {"orders", json_of(summary.orders)},
                     {"growth", json_of(summary.growth)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace wavecurve::verification
