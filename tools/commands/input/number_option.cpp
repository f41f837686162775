#include "tools/commands/input/number_option.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::tools {

namespace {

constexpr long most_pixels = 1L << 25;  ///< what render_frames takes

/// The text as a whole; std::from_chars knows no sign +.
template <class Number>
std::optional<Number> parsed(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

CLI::Validator check_of(const std::string& bounds, const std::string& unit,
                        std::function<bool(const std::string&)> is_within) {
  const std::string kind = bounds + (unit.empty() ? "" : " (" + unit + ")");
  const auto refusal = [kind, is_within = std::move(is_within)](const std::string& text) {
    return is_within(text)
               ? std::string()
               : fmt::format("{} is not a {}", value_text(std::string_view(text)), kind);
  };
  return {refusal, bounds.substr(bounds.find("number ") + 7), number_check};
}

}  // namespace

std::optional<double> parsed_number(std::string_view text) {
  const auto number = parsed<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<long> parsed_whole_number(std::string_view text) { return parsed<long>(text); }

CLI::Validator number_from(double least, double most, const std::string& unit) {
  return check_of(fmt::format("number from {:g} to {:g}", least, most), unit,
                  [=](const std::string& text) {
                    const auto number = parsed_number(text);
                    return number && *number >= least && *number <= most;
                  });
}

CLI::Validator number_above(double bound, double most, const std::string& unit) {
  return check_of(fmt::format("number above {:g}, at most {:g}", bound, most), unit,
                  [=](const std::string& text) {
                    const auto number = parsed_number(text);
                    return number && *number > bound && *number <= most;
                  });
}

CLI::Validator whole_number_from(long least, long most, const std::string& unit) {
  return check_of(fmt::format("whole number from {} to {}", least, most), unit,
                  [=](const std::string& text) {
                    const auto number = parsed_whole_number(text);
                    return number && *number >= least && *number <= most;
                  });
}

CLI::Validator frames_check() { return whole_number_from(2, 100000); }

CLI::Validator samples_check() { return whole_number_from(1, 1L << 20); }

CLI::Validator levels_check() { return whole_number_from(0, 20); }

CLI::Validator duration_check() { return number_from(0.001, 86400, "seconds"); }

CLI::Validator tolerance_check() { return number_from(0, 1e9, "units of the drawing"); }

std::optional<std::pair<int, int>> parsed_size(std::string_view text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto width = parsed_whole_number(text.substr(0, cross));
  const auto height = parsed_whole_number(text.substr(cross + 1));
  if (!width || !height || std::min(*width, *height) < 2 || std::max(*width, *height) > 16384 ||
      *width * *height > most_pixels) {
    return std::nullopt;
  }
  return std::pair(static_cast<int>(*width), static_cast<int>(*height));
}

CLI::Validator size_check() {
  return {[](const std::string& text) {
            return parsed_size(text)
                       ? std::string()
                       : fmt::format(
                             "{} is not a size WIDTHxHEIGHT of numbers from 2 to 16384, "
                             "together at most {} pixels",
                             value_text(std::string_view(text)), most_pixels);
          },
          "WIDTHxHEIGHT", number_check};
}

}  // namespace wavecurve::tools
