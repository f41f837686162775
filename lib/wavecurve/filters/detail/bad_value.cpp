#include "wavecurve/filters/detail/bad_value.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "wavecurve/filters/detail/characters.hpp"

namespace wavecurve {

std::string value_text(double value) { return fmt::format("{}", value); }

std::string value_text(std::string_view value) {
  constexpr std::size_t shown = 60;
  return fmt::format("'{}'", printable(value, shown));
}

void refuse_below(std::string_view name, double value, double least) {
  throw std::invalid_argument(must_be(name, value, fmt::format("finite and at least {}", least)));
}

void check_between(std::string_view name, long value, long least, long most) {
  if (least <= value && value <= most) return;
  throw std::invalid_argument(must_be(name, value, fmt::format("from {} to {}", least, most)));
}

void check_above_zero(std::string_view name, double value) {
  if (std::isfinite(value) && value > 0) return;
  throw std::invalid_argument(must_be(name, value, "finite and above 0"));
}

std::string unknown_name(std::string_view kind, std::string_view name,
                         const std::vector<std::string>& known) {
  return fmt::format("unknown {} {}; known: {}", kind, value_text(name), fmt::join(known, ", "));
}

}  // namespace wavecurve
