#include "wavecurve/io/files/detail/json_place.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::io {

namespace {

/// How many letters must be put in, taken out or changed (Levenshtein).
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// "; do you mean 'taps'?" where one of the names is but a slip away.
std::string guess(std::string_view name, const std::vector<std::string>& known) {
  constexpr std::size_t longest = 60, most_edits = 2;
  if (name.size() > longest || known.empty()) return "";
  const auto nearest = std::ranges::min_element(
      known, {}, [&](const std::string& other) { return edits_between(name, other); });
  if (edits_between(name, *nearest) > std::min(most_edits, name.size() / 2)) return "";
  return fmt::format("; do you mean '{}'?", *nearest);
}

/// The JSON library takes an integer above the largest of 64 bits with a sign for a negative one.
template <class Json>
bool exceeds_signed(const Json& value) {
  return value.is_number_unsigned() &&
         value.template get<std::uint64_t>() > std::numeric_limits<std::int64_t>::max();
}

/// A value for a message, on one line and short.
template <class Json>
std::string brief(const Json& value) {
  if (value.is_array()) return fmt::format("a list of {}", value.size());
  if (value.is_object()) return "an object";
  if (value.is_string())
    return value_text(std::string_view(value.template get_ref<const std::string&>()));
  return value.dump();
}

}  // namespace

template <class Json>
void BasicJsonPlace<Json>::refuse(const std::string& bound) const {
  throw std::invalid_argument(fmt::format(
      "{} is {}, but must be {}", path_.empty() ? "the document" : path_, brief(*value_), bound));
}

template <class Json>
void BasicJsonPlace<Json>::check_keys(const std::vector<std::string>& known) const {
  if (!value_->is_object()) refuse("an object");
  for (const auto& [key, value] : value_->items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    throw std::invalid_argument((path_.empty() ? "" : path_ + ": ") +
                                unknown_name("key", key, known) + guess(key, known));
  }
}

template <class Json>
std::optional<BasicJsonPlace<Json>> BasicJsonPlace<Json>::find(const std::string& key) const {
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return BasicJsonPlace(*found, path_.empty() ? key : path_ + "." + key);
}

template <class Json>
BasicJsonPlace<Json> BasicJsonPlace<Json>::at(const std::string& key) const {
  if (auto found = find(key)) return *found;
  throw std::invalid_argument((path_.empty() ? "the document" : path_) + " has no key '" + key +
                              "'");
}

template <class Json>
std::vector<BasicJsonPlace<Json>> BasicJsonPlace<Json>::elements(
    std::optional<std::size_t> size) const {
  if (!value_->is_array() || value_->size() != size.value_or(value_->size())) {
    refuse(size ? fmt::format("a list of {}", *size) : "a list");
  }
  std::vector<BasicJsonPlace> elements;
  for (std::size_t i = 0; i < value_->size(); ++i) {
    elements.push_back(BasicJsonPlace((*value_)[i], fmt::format("{}[{}]", path_, i)));
  }
  return elements;
}

template <class Json>
std::vector<std::pair<std::string, BasicJsonPlace<Json>>> BasicJsonPlace<Json>::items() const {
  if (!value_->is_object()) refuse("an object");
  std::vector<std::pair<std::string, BasicJsonPlace>> items;
  for (const auto& [key, value] : value_->items()) {
    items.emplace_back(key, BasicJsonPlace(value, path_.empty() ? key : path_ + "." + key));
  }
  return items;
}

template <class Json>
std::string BasicJsonPlace<Json>::text() const {
  if (!value_->is_string()) refuse("a text");
  return value_->template get<std::string>();
}

template <class Json>
int BasicJsonPlace<Json>::whole_number(int least, int most) const {
  const bool is_small = value_->is_number_integer() && !exceeds_signed(*value_);
  const auto number = is_small ? value_->template get<std::int64_t>() : 0;
  if (!is_small || number < least || number > most) {
    refuse(fmt::format("a whole number from {} to {}", least, most));
  }
  return static_cast<int>(number);
}

template <class Json>
double BasicJsonPlace<Json>::number(double least, double most) const {
  const double number = value_->is_number() ? value_->template get<double>() : std::nan("");
  if (std::isfinite(number) && number >= least && number <= most) return number;
  const bool has_bounds = least > std::numeric_limits<double>::lowest();
  refuse(has_bounds ? fmt::format("a number from {} to {}", least, most) : "a finite number");
}

template <class Json>
bool BasicJsonPlace<Json>::boolean() const {
  if (!value_->is_boolean()) refuse("true or false");
  return value_->template get<bool>();
}

template <class Json>
std::string BasicJsonPlace<Json>::one_of(const std::vector<std::string>& known) const {
  const bool is_known = value_->is_string() && std::ranges::find(known, text()) != known.end();
  if (!is_known) refuse(fmt::format("{}", fmt::join(known, " or ")));
  return text();
}

template class BasicJsonPlace<nlohmann::json>;
template class BasicJsonPlace<nlohmann::ordered_json>;

void check_kind(const JsonPlace& document, const std::string& format, int version) {
  const auto found = document.find("format");
  if (!found || found->value() != format) {
    throw std::invalid_argument(fmt::format("\"format\" must be \"{}\"", format));
  }
  if (document.at("version").value() != version) {
    document.at("version").refuse(std::to_string(version));
  }
}

}  // namespace wavecurve::io
