#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace wavecurve::io {

// Values of our own JSON documents, checked; what is refused throws std::invalid_argument naming
// the value and the bound.

/// A number of at most `largest` in magnitude. What is too large for a double is refused: JSON has
/// no infinities, and it comes as one.
double number_in(const nlohmann::json& value, const std::string& what,
                 double largest = std::numeric_limits<double>::max());

/// Whether it is an integer above the largest of 64 bits with a sign: the JSON library takes it for a
/// negative one.
template <class Json>
bool exceeds_signed(const Json& value) {
  return value.is_number_unsigned() &&
         value.template get<std::uint64_t>() > std::numeric_limits<std::int64_t>::max();
}

/// An integer from `least` to `most`.
long whole_number(const nlohmann::json& value, const std::string& what, long least, long most);

/// That "format" and "version" are what is read here.
void check_kind(const nlohmann::json& document, const std::string& format, int version);

/// A text as JSON has it; what is no UTF-8 becomes U+FFFD.
std::string quoted(const std::string& text);

}  // namespace wavecurve::io
