#include "wavecurve/io/filter_json.hpp"

#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/detail/json_values.hpp"
#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve::io {

namespace {

using nlohmann::json;

[[noreturn]] void refuse_filter(const std::filesystem::path& path, const std::string& defect) {
  throw std::invalid_argument(path.string() + ": " + defect);
}

int small_integer(const json& object, const char* key) {
  constexpr long most = 1000000;
  return static_cast<int>(whole_number(object.at(key), key, -most, most));
}

std::string decimal(const json& tap) {
  if (tap.is_string()) return tap.get<std::string>();
  if (tap.is_number()) return fmt::format("{}", tap.get<double>());
  throw std::invalid_argument("a tap must be a decimal in quotes or a number");
}

Filter<std::string> filter_of(const json& object) {
  Filter<std::string> filter;
  if (!object.is_object() || !object.contains("taps") || !object["taps"].is_array()) {
    throw std::invalid_argument("a filter needs a list \"taps\"");
  }
  if (object.contains("first_index")) filter.first_index = small_integer(object, "first_index");
  for (const json& tap : object["taps"]) filter.taps.push_back(decimal(tap));
  return filter;
}

UserFilter user_filter_of(const json& document, const std::string& default_name) {
  UserFilter user;
  if (!document.is_object()) throw std::invalid_argument("a filter file holds one JSON object");
  user.name = document.value("name", document.value("filter", default_name));
  if (document.contains("analysis_low") && document.contains("synthesis_low")) {
    user.taps = filter_of(document["synthesis_low"]);
    user.dual = filter_of(document["analysis_low"]);
  } else {
    user.taps = filter_of(document.contains("analysis_low") ? document["analysis_low"] : document);
    if (document.contains("dual")) user.dual = filter_of(document["dual"]);
  }
  if (user.dual == user.taps) user.dual.reset();
  user.sum = document.value("sum", user.sum);
  if (document.contains("vanishing_moments")) {
    user.vanishing_moments = small_integer(document, "vanishing_moments");
  }
  if (document.contains("dual_vanishing_moments")) {
    user.dual_vanishing_moments = small_integer(document, "dual_vanishing_moments");
  }
  return user;
}

}  // namespace

UserFilter read_filter_json(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  try {
    return user_filter_of(json::parse(text), path.stem().string());
  } catch (const json::exception& error) {
    constexpr std::size_t shown = 120;
    refuse_filter(
        path, std::string("not a filter in JSON: ") + std::string(error.what()).substr(0, shown));
  } catch (const std::invalid_argument& error) {
    refuse_filter(path, error.what());
  }
}

}  // namespace wavecurve::io
