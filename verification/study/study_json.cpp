#include "verification/study/study_json.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/json_place.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"
#include "wavecurve/io/files/detail/json_writer.hpp"
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

Json json_of(const StudySetting& setting) {
  return {{"filter", setting.filter},
          {"samples", setting.samples},
          {"levels", setting.levels},
          {"shape", setting.shape},
          {"damping", {setting.mass_damping, setting.stiffness_damping}}};
}

Json json_of(const std::string& solver, const StudySetting& setting) {
  Json json = {{"solver", solver}};
  json.update(json_of(setting));
  return json;
}

Json json_of(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

void write_list(io::JsonWriter& writer, std::initializer_list<double> numbers) {
  writer.open('[');
  for (const double number : numbers) writer.value(number);
  writer.close(']');
}

void write_result(io::JsonWriter& writer, const StudyPoint& point) {
  if (!point.errors) {
    for (const char* name : {"error", "energy_drift", "cost"}) {
      writer.key(name);
      writer.null();
    }
    return;
  }
  writer.key("error");
  writer.open('{');
  for (const auto& [name, member] : error_names) writer.member(name, (*point.errors).*member);
  writer.close('}');
  writer.member("energy_drift", point.errors->energy_drift);
  writer.key("cost");
  writer.open('{');
  writer.member("evaluations", point.cost.evaluations);
  writer.member("operations", point.cost.operations);
  writer.member("seconds", point.seconds);
  writer.close('}');
}

/// Not by a document of nlohmann's: there are millions of points, and each of them would be made of
/// some eighty pieces of memory.
std::string text_of(const StudyPoint& point, int indent, int level) {
  io::JsonWriter writer(indent, level);
  const StudySetting& setting = *point.setting;
  writer.open('{');
  writer.member("solver", std::string_view(point.solver));
  writer.member("filter", std::string_view(setting.filter));
  writer.member("samples", static_cast<long long>(setting.samples));
  writer.member("levels", static_cast<long long>(setting.levels));
  writer.member("shape", std::string_view(setting.shape));
  writer.key("damping");
  write_list(writer, {setting.mass_damping, setting.stiffness_damping});
  writer.key("tolerance");
  if (point.tolerance) {
    writer.value(*point.tolerance);
  } else {
    writer.null();
  }
  write_result(writer, point);
  if (!point.model_errors.empty()) {
    writer.key("model_errors");
    writer.open('[');
    for (const double error : point.model_errors) writer.value(error);
    writer.close(']');
  }
  writer.member("status", std::string_view(point.failure.empty() ? "ok" : "failed"));
  if (!point.failure.empty()) writer.member("reason", std::string_view(point.failure));
  writer.member("fingerprint", std::string_view(fmt::format("{:016x}", point.fingerprint)));
  writer.close('}');
  return std::move(writer).text();
}

Json json_of(const PowerFit& fit) {
  return {{"exponent", fit.exponent}, {"interval_95", {fit.low, fit.high}}};
}

Json json_of(const ErrorFloor& floor) {
  Json json = json_of(floor.solver, *floor.setting);
  json["displacement_l2_max"] = floor.displacement_l2_max;
  json["energy_norm_max"] = floor.energy_norm_max;
  json["cause"] = "model";
  return json;
}

Json json_of(const ObservedOrder& order) {
  Json json = json_of(order.solver, *order.setting);
  json["tolerances"] = order.tolerances;
  json["order"] = json_of(order.fit);
  return json;
}

Json json_of(const Growth& growth) {
  Json json = json_of(growth.solver, *growth.setting);
  json["samples"] = growth.samples;
  json["tolerance"] = json_of(growth.tolerance);
  json["operations"] = json_of(growth.operations);
  json["seconds"] = json_of(growth.seconds);
  return json;
}

template <class T>
std::string text_of(const T& item, int indent, int level) {
  std::string text;
  for (const char c : io::json_text(json_of(item), indent)) {
    text += c;
    if (c == '\n') text.append(static_cast<std::size_t>(indent * level), ' ');
  }
  return text;
}

/// "name": [the items, one after the other], indented in a document.
template <class T>
void write_list(const char* name, const std::vector<T>& items, const io::TextSink& sink) {
  constexpr int indent = 2, level = 2;
  sink(fmt::format("  \"{}\": [", name));
  for (std::size_t i = 0; i < items.size(); ++i) {
    sink(i == 0 ? "\n    " : ",\n    ");
    sink(text_of(items[i], indent, level));
  }
  sink(items.empty() ? "]" : "\n  ]");
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

std::uint64_t fingerprint_of(const Place& place) {
  const std::string text = place.text();
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, 16);
  if (text.size() != 16 || stop != end || error != std::errc()) {
    place.refuse("16 hexadecimal digits");
  }
  return value;
}

StudyPoint point_of(const Place& place) {
  StudyPoint point;
  point.setting = std::make_shared<const StudySetting>(setting_of(place));
  point.solver = place.at("solver").text();
  const Place tolerance = place.at("tolerance");
  if (!tolerance.value().is_null()) point.tolerance = tolerance.number();
  point.fingerprint = fingerprint_of(place.at("fingerprint"));
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

std::string to_json_line(const StudyPoint& point) { return text_of(point, -1, 0); }

StudyPoint point_of_json_line(const std::string& line) {
  try {
    const Json document = io::parse_ordered_json(line);
    return point_of(Place(document));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("no point of a study: ") + error.what());
  }
}

std::string to_json(const StudyPlan& plan) {
  Json json = {{"settings", Json::array()}, {"solvers", plan.solvers}};
  for (const StudySetting& setting : plan.settings) json["settings"].push_back(json_of(setting));
  return io::json_text(json, 2) + "\n";
}

StudyPlan plan_of_json(const std::string& text) {
  try {
    const Json document = io::parse_ordered_json(text);
    const Place place(document);
    StudyPlan plan;
    for (const Place& setting : place.at("settings").elements()) {
      plan.settings.push_back(setting_of(setting));
    }
    for (const Place& solver : place.at("solvers").elements()) {
      plan.solvers.push_back(solver.text());
    }
    return plan;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("no plan of a study: ") + error.what());
  }
}

void write_json(const std::vector<StudyPoint>& points, const StudySummary& summary,
                const io::TextSink& sink) {
  sink("{\n");
  write_list("points", points, sink);
  sink(",\n");
  write_list("floors", summary.floors, sink);
  sink(",\n");
  write_list("orders", summary.orders, sink);
  sink(",\n");
  write_list("growth", summary.growth, sink);
  sink("\n}\n");
}

}  // namespace wavecurve::verification
