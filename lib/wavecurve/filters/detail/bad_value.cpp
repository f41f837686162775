#include "wavecurve/filters/detail/bad_value.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve {

namespace {

void demand(bool condition, std::string_view name, const auto& value, std::string_view bound) {
  if (!condition) throw std::invalid_argument(must_be(name, value, bound));
}

}  // namespace

std::string value_text(double value) { return fmt::format("{}", value); }

std::string value_text(std::string_view value) {
  constexpr std::size_t shown = 60;
  std::string text(value.substr(0, shown));
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');
  return "'" + text + (value.size() > shown ? "...'" : "'");
}

void check_at_least(std::string_view name, double value, double least) {
  demand(std::isfinite(value) && value >= least, name, value,
         fmt::format("finite and at least {}", least));
}

void check_between(std::string_view name, long value, long least, long most) {
  demand(least <= value && value <= most, name, value, fmt::format("from {} to {}", least, most));
}

void check_above_zero(std::string_view name, double value) {
  demand(std::isfinite(value) && value > 0, name, value, "finite and above 0");
}

std::string unknown_name(std::string_view kind, std::string_view name,
                         const std::vector<std::string>& known) {
  return fmt::format("unknown {} {}; known: {}", kind, value_text(name), fmt::join(known, ", "));
}

}  // namespace wavecurve
