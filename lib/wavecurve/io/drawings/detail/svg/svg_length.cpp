#include "wavecurve/io/drawings/detail/svg/svg_length.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

/// Reads the number at the begin of the text and removes it.
std::optional<double> take_number(std::string_view& text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

/// The share of the free space that lies before the content: xMin, xMid or xMax; the same for y.
double share(std::string_view alignment) {
  if (alignment == "Min") return 0;
  return alignment == "Max" ? 1 : 0.5;
}

}  // namespace

double Viewport::diagonal() const { return std::hypot(width, height) / std::sqrt(2.0); }

std::optional<double> parse_number(std::string_view text) {
  text = trimmed(text);
  const auto value = take_number(text);
  return text.empty() ? value : std::nullopt;
}

std::optional<double> parse_length(std::string_view text, double hundred_percent) {
  text = trimmed(text);
  const auto value = take_number(text);
  if (!value) return std::nullopt;
  const std::string unit = lower_case(trimmed(text));
  const std::pair<std::string_view, double> units[] = {{"", 1},
                                                       {"px", 1},
                                                       {"in", 96},
                                                       {"cm", 96 / 2.54},
                                                       {"mm", 9.6 / 2.54},
                                                       {"pt", 4.0 / 3},
                                                       {"pc", 16},
                                                       {"em", 16},
                                                       {"rem", 16},
                                                       {"ex", 8},
                                                       {"%", hundred_percent / 100}};
  for (const auto& [name, factor] : units) {
    if (name == unit) return *value * factor;
  }
  return std::nullopt;
}

ViewBox parse_view_box(std::string_view text) {
  const auto pieces = split(text, " ,\t\r\n");
  double values[4] = {};
  bool valid = pieces.size() == 4;
  for (std::size_t i = 0; valid && i < 4; ++i) {
    const auto value = parse_number(pieces[i]);
    valid = value && std::abs(*value) <= 1e9;
    if (valid) values[i] = *value;
  }
  const ViewBox box{values[0], values[1], values[2], values[3]};
  if (!valid || !(box.width > 0) || !(box.height > 0)) {
    throw std::invalid_argument("viewBox '" + shown(text) +
                                "' is not four numbers up to 1e9, the last two positive");
  }
  return box;
}

ViewBox box_of_lengths(std::string_view width, std::string_view height) {
  const auto wide = parse_length(width, 0), high = parse_length(height, 0);
  if (!wide || !high || !(*wide > 0) || !(*high > 0)) return {};
  return {0, 0, *wide, *high};
}

Eigen::Affine2d view_box_transform(const ViewBox& box, const ViewBox& shown,
                                   std::string_view preserve_aspect_ratio) {
  const auto words = split(preserve_aspect_ratio, " \t\r\n");
  const std::string_view alignment = words.empty() ? "xMidYMid" : words.front();
  const bool slice = words.size() > 1 && words[1] == "slice";
  Eigen::Vector2d scale(shown.width / box.width, shown.height / box.height);
  if (alignment != "none") scale.setConstant(slice ? scale.maxCoeff() : scale.minCoeff());
  const Eigen::Vector2d free(shown.width - scale.x() * box.width,
                             shown.height - scale.y() * box.height);
  Eigen::Vector2d before = free / 2;
  if (alignment.size() == 8) {
    before = {share(alignment.substr(1, 3)) * free.x(), share(alignment.substr(5, 3)) * free.y()};
  }
  Eigen::Affine2d transform = Eigen::Affine2d::Identity();
  transform.translate(Eigen::Vector2d(shown.x, shown.y) + before);
  transform.scale(scale);
  transform.translate(Eigen::Vector2d(-box.x, -box.y));
  return transform;
}

}  // namespace wavecurve::io
