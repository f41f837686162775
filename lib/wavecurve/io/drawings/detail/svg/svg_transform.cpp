#include "wavecurve/io/drawings/detail/svg/svg_transform.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_values.hpp"
#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

using Eigen::Affine2d;
using Eigen::Vector2d;

/// A number of CSS that must have one of the units, but for zero.
std::optional<double> number_with_unit(
    std::string_view text, std::initializer_list<std::pair<std::string_view, double>> units) {
  text = trimmed(text);
  if (const auto plain = parse_number(text)) return *plain == 0 ? plain : std::nullopt;
  for (const auto& [unit, factor] : units) {
    if (!text.ends_with(unit)) continue;
    if (const auto value = parse_number(text.substr(0, text.size() - unit.size()))) {
      return *value * factor;
    }
  }
  return std::nullopt;
}

std::optional<double> radians_of(std::string_view text) {
  constexpr double degree = std::numbers::pi / 180;
  return number_with_unit(lower_case(text), {{"deg", degree},
                                             {"grad", std::numbers::pi / 200},
                                             {"rad", 1},
                                             {"turn", 2 * std::numbers::pi}});
}

std::optional<double> length_of(std::string_view text, double hundred_percent) {
  if (const auto plain = parse_number(text)) return *plain == 0 ? plain : std::nullopt;
  return parse_length(text, hundred_percent);
}

std::optional<double> factor_of(std::string_view text) {
  if (!text.ends_with('%')) return parse_number(text);
  const auto percent = parse_number(text.substr(0, text.size() - 1));
  return percent ? std::optional(*percent / 100) : std::nullopt;
}

Affine2d matrix(double a, double b, double c, double d, double e, double f) {
  Affine2d result = Affine2d::Identity();
  result.matrix().topRows<2>() << a, c, e, b, d, f;
  return result;
}

using Arguments = std::vector<std::string_view>;

std::optional<Affine2d> translation(std::string_view name, const Arguments& arguments,
                                    const Viewport& viewport) {
  if (arguments.empty() || arguments.size() > (name == "translate" ? 2 : 1)) return std::nullopt;
  const bool down = name == "translatey";
  const auto first = length_of(arguments[0], down ? viewport.height : viewport.width);
  const auto second = arguments.size() > 1 ? length_of(arguments[1], viewport.height) : 0.0;
  if (!first || !second) return std::nullopt;
  return matrix(1, 0, 0, 1, down ? 0 : *first, down ? *first : *second);
}

std::optional<Affine2d> scaling(std::string_view name, const Arguments& arguments) {
  if (arguments.empty() || arguments.size() > (name == "scale" ? 2 : 1)) return std::nullopt;
  const auto first = factor_of(arguments[0]);
  const auto second = arguments.size() > 1 ? factor_of(arguments[1]) : first;
  if (!first || !second) return std::nullopt;
  return matrix(name == "scaley" ? 1 : *first, 0, 0, name == "scalex" ? 1 : *second, 0, 0);
}

std::optional<Affine2d> turn(const Arguments& arguments) {
  const auto angle = arguments.size() == 1 ? radians_of(arguments[0]) : std::nullopt;
  if (!angle) return std::nullopt;
  return matrix(cosine(*angle), sine(*angle), -sine(*angle), cosine(*angle), 0, 0);
}

std::optional<Affine2d> skewing(std::string_view name, const Arguments& arguments) {
  if (arguments.empty() || arguments.size() > (name == "skew" ? 2 : 1)) return std::nullopt;
  const auto first = radians_of(arguments[0]);
  const auto second = arguments.size() > 1 ? radians_of(arguments[1]) : 0.0;
  if (!first || !second) return std::nullopt;
  const bool along_y = name == "skewy";
  return matrix(1, tangent(along_y ? *first : *second), along_y ? 0 : tangent(*first), 1, 0, 0);
}

std::optional<Affine2d> function_of(std::string_view name, const Arguments& arguments,
                                    const Viewport& viewport) {
  if (name.starts_with("translate")) return translation(name, arguments, viewport);
  if (name.starts_with("scale")) return scaling(name, arguments);
  if (name == "rotate" || name == "rotatez") return turn(arguments);
  if (name.starts_with("skew")) return skewing(name, arguments);
  if (name != "matrix" || arguments.size() != 6) return std::nullopt;
  double m[6] = {};
  for (std::size_t i = 0; i < 6; ++i) {
    const auto value = parse_number(arguments[i]);
    if (!value) return std::nullopt;
    m[i] = *value;
  }
  return matrix(m[0], m[1], m[2], m[3], m[4], m[5]);
}

bool is_known(std::string_view name) {
  constexpr std::string_view names[] = {"matrix",  "translate", "translatex", "translatey",
                                        "scale",   "scalex",    "scaley",     "rotate",
                                        "rotatez", "skew",      "skewx",      "skewy"};
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

}  // namespace

Affine2d parse_css_transform(std::string_view text, const Viewport& viewport) {
  Affine2d product = Affine2d::Identity();
  std::string_view rest = trimmed(text);
  if (lower_case(rest) == "none") return product;
  while (!rest.empty()) {
    const std::size_t open = rest.find('('), close = rest.find(')');
    std::optional<Affine2d> factor;
    if (open != std::string_view::npos && close != std::string_view::npos && open < close) {
      const std::string name = lower_case(trimmed(rest.substr(0, open)));
      const auto arguments = split(rest.substr(open + 1, close - open - 1), ", \t\r\n");
      if (is_known(name)) factor = function_of(name, arguments, viewport);
    }
    if (!factor) throw std::invalid_argument(fmt::format("no transform of CSS: '{}'", shown(rest)));
    product = product * *factor;
    rest = trimmed(rest.substr(close + 1));
  }
  return product;
}

Affine2d transform_of(const XmlElement& element, const Properties& properties,
                      const Viewport& viewport) {
  const auto property = properties.find("transform"), origin = properties.find("transform-origin");
  const bool by_css = property != properties.end();
  const std::string_view text = by_css ? property->second : element.attribute("transform");
  if (text.empty()) return Affine2d::Identity();
  const Affine2d transform = by_css ? parse_css_transform(text, viewport) : parse_transform(text);
  if (origin == properties.end()) return transform;
  const Vector2d fixed = parse_transform_origin(origin->second, viewport);
  return Eigen::Translation2d(fixed) * transform * Eigen::Translation2d(-fixed);
}

Vector2d parse_transform_origin(std::string_view text, const Viewport& viewport) {
  auto words = split(text, " ,\t\r\n");
  const auto refuse = [&] {
    throw std::invalid_argument(fmt::format("no transform-origin: '{}'", shown(text)));
  };
  if (words.empty() || words.size() > 3) refuse();
  const auto is_across = [](std::string_view word) { return word == "left" || word == "right"; };
  const auto is_down = [](std::string_view word) { return word == "top" || word == "bottom"; };
  if (words.size() == 1) words.emplace_back("center");
  if (is_down(words[0]) || is_across(words[1])) std::swap(words[0], words[1]);
  if (is_down(words[0]) || is_across(words[1])) refuse();
  const auto at = [&](std::string_view word, double whole) {
    if (word == "left" || word == "top") return 0.0;
    if (word == "right" || word == "bottom") return whole;
    if (word == "center") return whole / 2;
    const auto value = parse_length(word, whole);
    if (!value) refuse();
    return *value;
  };
  return {at(words[0], viewport.width), at(words[1], viewport.height)};
}

bool scales_evenly(const Eigen::Affine2d& transform) {
  const Eigen::Matrix2d square = transform.linear().transpose() * transform.linear();
  const double mean = square.trace() / 2;
  return (square - mean * Eigen::Matrix2d::Identity()).norm() <= 1e-6 * mean;
}

}  // namespace wavecurve::io
