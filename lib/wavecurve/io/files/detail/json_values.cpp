#include "wavecurve/io/files/detail/json_values.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/json_text.hpp"

namespace wavecurve::io {

using nlohmann::json;

double number_in(const json& value, const std::string& what, double largest) {
  const double result = value.is_number() ? value.get<double>() : std::nan("");
  if (!(std::abs(result) <= largest)) {
    throw std::invalid_argument(fmt::format("{} is {}, but must be a finite number{}", what,
                                            value.dump(), largest <= 1 ? " up to 1" : ""));
  }
  return result;
}

long whole_number(const json& value, const std::string& what, long least, long most) {
  if (!value.is_number_integer() || exceeds_signed(value) || value < least || value > most) {
    throw std::invalid_argument(fmt::format("{} is {}, but must be a whole number from {} to {}",
                                            what, value.dump(), least, most));
  }
  return value.get<long>();
}

void check_kind(const json& document, const std::string& format, int version) {
  if (!document.is_object() || document.value("format", json()) != format) {
    throw std::invalid_argument(fmt::format("\"format\" must be \"{}\"", format));
  }
  if (document.at("version") != version) {
    throw std::invalid_argument(
        fmt::format("version is {}, but must be {}", document.at("version").dump(), version));
  }
}

std::string quoted(const std::string& text) { return json_text(json(text)); }

}  // namespace wavecurve::io
