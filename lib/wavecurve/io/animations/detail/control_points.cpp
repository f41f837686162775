#include "wavecurve/io/animations/detail/control_points.hpp"

#include <cstddef>

#include <fmt/format.h>

#include "wavecurve/curves/fit_cubics.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/drawings/detail/svg_paint.hpp"
#include "wavecurve/motion/detail/check_animation.hpp"

namespace wavecurve::io {

namespace {

void fit(motion::AnimatedLayer& layer, double tolerance) {
  for (std::size_t i = 0; i < layer.outline.front().contours.size(); ++i) {
    std::vector<Contour> keys;
    for (const motion::OutlineKey& key : layer.outline) keys.push_back(key.contours[i]);
    keys = fit_cubics(keys, tolerance, is_open(layer, i) ? Closing::open : Closing::joined);
    for (std::size_t k = 0; k < keys.size(); ++k) layer.outline[k].contours[i] = keys[k];
  }
}

void append_point(std::string& text, const Contour& contour, Eigen::Index row,
                  const Decimals& decimals) {
  decimals.append(text, contour(row, 0));
  text += ' ';
  decimals.append(text, contour(row, 1));
}

}  // namespace

AnimatedControlPoints control_points(const motion::Animation& animation, double tolerance) {
  motion::check_animation(animation);
  check_at_least("tolerance", tolerance, 0);
  AnimatedControlPoints result{animation, tolerance > 0};
  if (!result.cubic) return result;
  for (motion::AnimatedLayer& layer : result.animation.layers) fit(layer, tolerance);
  return result;
}

std::string path_data(const std::vector<Contour>& contours, bool cubic, const Decimals& decimals,
                      const std::vector<bool>& open) {
  std::string text;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const Contour& contour = contours[i];
    const bool is_closed = i >= open.size() || !open[i];
    text += 'M';
    append_point(text, contour, 0, decimals);
    const Eigen::Index rows = contour.rows();
    // A polygon is closed by z; a cubic ends where it started.
    const Eigen::Index end = cubic && is_closed ? rows + 1 : rows;
    for (Eigen::Index row = 1; row < end; ++row) {
      text += row > 1 ? ' ' : cubic ? 'C' : 'L';
      append_point(text, contour, row % rows, decimals);
    }
    if (is_closed) text += 'z';
  }
  return text;
}

std::string layers_svg(const std::vector<motion::FrameLayer>& layers, bool cubic,
                       const Decimals& decimals) {
  std::string svg;
  for (const motion::FrameLayer& layer : layers) {
    svg += "<path";
    for (const auto& [name, value] : svg_paint(layer.paint)) {
      svg += fmt::format(" {}=\"{}\"", name, value);
    }
    svg += fmt::format(" d=\"{}\"/>\n", path_data(layer.contours, cubic, decimals, layer.open));
  }
  return svg;
}

}  // namespace wavecurve::io
