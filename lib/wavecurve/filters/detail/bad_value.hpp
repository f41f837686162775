#pragma once

#include <cmath>
#include <concepts>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace wavecurve {

// What is said of a bad value, everywhere in the same words: the value, and the bound or the names
// that are known.

/// A value for a message: a number as short as it reads back; a text in quotes, of a long one the
/// first 60 characters, and U+FFFD for each that does not show (characters.hpp).
std::string value_text(double value);
std::string value_text(std::string_view value);
template <std::integral Integer>
std::string value_text(Integer value) {
  return std::to_string(value);
}

/// "NAME is VALUE, but must be BOUND".
template <class Value>
std::string must_be(std::string_view name, const Value& value, std::string_view bound) {
  return std::string(name) + " is " + value_text(value) + ", but must be " + std::string(bound);
}

/// Throws what check_at_least does: apart, for the check stands in inner loops.
[[noreturn]] void refuse_below(std::string_view name, double value, double least);

/// Throw std::invalid_argument with such a message unless the value is at least, and at most, so
/// much; a number that need not be whole must be finite, too.
template <std::integral Integer>
void check_at_least(std::string_view name, Integer value, long least) {
  if (value >= static_cast<Integer>(least)) return;
  throw std::invalid_argument(must_be(name, value, "at least " + std::to_string(least)));
}
inline void check_at_least(std::string_view name, double value, double least) {
  if (!(std::isfinite(value) && value >= least)) refuse_below(name, value, least);
}
void check_between(std::string_view name, long value, long least, long most);
void check_above_zero(std::string_view name, double value);

/// "unknown KIND 'NAME'; known: FIRST, SECOND, ...".
std::string unknown_name(std::string_view kind, std::string_view name,
                         const std::vector<std::string>& known);

/// The same for any range; the projection gives the name of an element.
template <class Range, class Projection = std::identity>
std::string unknown_name(std::string_view kind, std::string_view name, const Range& known,
                         Projection projection = {}) {
  std::vector<std::string> names;
  for (const auto& one : known) names.emplace_back(std::invoke(projection, one));
  return unknown_name(kind, name, static_cast<const std::vector<std::string>&>(names));
}

}  // namespace wavecurve
