#include "wavecurve/io/filter_json.hpp"

#include <stdexcept>

#include <nlohmann/json.hpp>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/files/detail/json_place.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"

namespace wavecurve::io {

namespace {

using Keys = std::vector<std::string>;

constexpr std::size_t largest_filter_file = std::size_t{1} << 20;
constexpr int largest_integer = 1000000;

/// A number as it is written, in quotes or not.
std::string number_as_written(const JsonPlace& place) {
  if (place.value().is_number_integer()) return place.value().dump();
  if (!place.value().is_string()) place.refuse("a number, in quotes or not");
  return place.text();
}

std::optional<std::string> optional_number(const JsonPlace& object, const char* key) {
  const auto place = object.find(key);
  return place ? std::optional(number_as_written(*place)) : std::nullopt;
}

std::optional<int> optional_count(const JsonPlace& object, const char* key) {
  const auto place = object.find(key);
  return place ? std::optional(place->whole_number(-largest_integer, largest_integer))
               : std::nullopt;
}

Filter<std::string> taps_of(const JsonPlace& side) {
  Filter<std::string> filter;
  for (const JsonPlace& tap : side.at("taps").elements()) {
    filter.taps.push_back(number_as_written(tap));
  }
  if (const auto first = side.find("first_index")) {
    filter.first_index = first->whole_number(-largest_integer, largest_integer);
  }
  return filter;
}

/// What "sum" and "accuracy" say of each side: one number for both, or one for each.
struct BothSides {
  std::optional<std::string> primal, dual;

  BothSides(const JsonPlace& document, const char* key) {
    const auto place = document.find(key);
    if (!place) return;
    if (!place->value().is_object()) {
      primal = number_as_written(*place);
      return;
    }
    place->check_keys({"primal", "dual"});
    primal = optional_number(*place, "primal");
    dual = optional_number(*place, "dual");
  }
};

const Keys keys_of_both_forms{"name", "sum", "accuracy", "vanishing_moments",
                              "dual_vanishing_moments"};
const Keys keys_of_a_side{"taps", "first_index", "sum", "accuracy"};

Keys operator+(Keys keys, const Keys& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

/// The two sides in whichever form they are written; nothing for an orthonormal filter.
struct Sides {
  JsonPlace primal;
  std::optional<JsonPlace> dual;
};

Sides sides_of(const JsonPlace& document) {
  if (!document.find("synthesis_low") && !document.find("analysis_low")) {
    document.check_keys(keys_of_both_forms + Keys{"taps", "first_index", "dual"});
    return {document, document.find("dual")};
  }
  // What `wavecurve filter` prints; the high-pass filters follow from the low-pass ones.
  document.check_keys(keys_of_both_forms + Keys{"filter", "analysis_low", "analysis_high",
                                                "synthesis_low", "synthesis_high", "diagnostics"});
  const auto synthesis = document.find("synthesis_low"), analysis = document.find("analysis_low");
  for (const auto& side : {synthesis, analysis}) {
    if (side) side->check_keys({"taps", "first_index"});
  }
  return {synthesis ? *synthesis : *analysis, synthesis ? analysis : std::nullopt};
}

std::string name_of(const JsonPlace& document, const std::string& default_name) {
  for (const char* key : {"name", "filter"}) {
    if (const auto name = document.find(key)) return name->text();
  }
  return default_name;
}

UserFilter user_filter_of(const JsonPlace& document, const std::string& default_name) {
  const auto [primal, dual] = sides_of(document);
  const BothSides sum(document, "sum"), accuracy(document, "accuracy");
  UserFilter user;
  user.name = name_of(document, default_name);
  user.taps = taps_of(primal);
  user.sum = sum.primal.value_or(user.sum);
  user.accuracy = accuracy.primal;
  if (!dual && (sum.dual || accuracy.dual)) {
    throw std::invalid_argument(std::string(sum.dual ? "sum" : "accuracy") +
                                ".dual is given, but there is no dual side");
  }
  if (dual) {
    dual->check_keys(keys_of_a_side);
    user.dual = taps_of(*dual);
    user.dual_sum = optional_number(*dual, "sum");
    if (!user.dual_sum) user.dual_sum = sum.dual;
    user.dual_accuracy = optional_number(*dual, "accuracy");
    if (!user.dual_accuracy) user.dual_accuracy = accuracy.dual;
    // Both sides are printed of an orthonormal filter, too.
    const bool is_same = user.dual == user.taps && user.dual_sum.value_or(user.sum) == user.sum &&
                         (!user.dual_accuracy || user.dual_accuracy == user.accuracy);
    if (is_same) user.dual.reset();
  }
  user.vanishing_moments = optional_count(document, "vanishing_moments");
  user.dual_vanishing_moments = optional_count(document, "dual_vanishing_moments");
  return user;
}

}  // namespace

UserFilter read_filter_json(const std::filesystem::path& path) {
  const auto document = read_json(path, JsonNumbers::as_written, largest_filter_file);
  try {
    return user_filter_of(JsonPlace(document), path.stem().string());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path.string() + ": " + error.what());
  }
}

}  // namespace wavecurve::io
