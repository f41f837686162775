#include "wavecurve/io/animations/detail/control_points.hpp"

#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/curves/fit_cubics.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/drawings/detail/svg_paint.hpp"
#include "wavecurve/motion/detail/check_animation.hpp"

namespace wavecurve::io {

namespace {

/// Keeps those keys between which all others are nearly linear, and tells whether one is gone. From a
/// kept key on, each key that follows leaves a range of slopes of every coordinate, within which a line
/// passes it near enough; the last key that lies within all of them is the next to be kept.
class KeyFit {
 public:
  KeyFit(const std::vector<motion::OutlineKey>& keys, double tolerance)
      : keys_(keys), reach_(tolerance / std::numbers::sqrt2) {}

  std::vector<std::size_t> kept() {
    std::vector<std::size_t> kept{0};
    start();
    for (std::size_t k = 1; k < keys_.size(); ++k) {
      if (!is_within(kept.back(), k)) {
        kept.push_back(k - 1);
        start();
      }
      narrow(kept.back(), k);
    }
    if (kept.back() + 1 != keys_.size()) kept.push_back(keys_.size() - 1);
    return kept;
  }

 private:
  void start() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    least_.clear();
    most_.clear();
    for (const Contour& contour : keys_.front().contours) {
      least_.emplace_back(Contour::Constant(contour.rows(), 2, -infinity));
      most_.emplace_back(Contour::Constant(contour.rows(), 2, infinity));
    }
  }
  bool is_within(std::size_t from, std::size_t to) const {
    const double time = keys_[to].time - keys_[from].time;
    for (std::size_t i = 0; i < least_.size(); ++i) {
      const auto way = (keys_[to].contours[i] - keys_[from].contours[i]).array();
      if (!(way >= time * least_[i].array() && way <= time * most_[i].array()).all()) return false;
    }
    return true;
  }
  void narrow(std::size_t from, std::size_t to) {
    const double time = keys_[to].time - keys_[from].time;
    for (std::size_t i = 0; i < least_.size(); ++i) {
      const auto way = (keys_[to].contours[i] - keys_[from].contours[i]).array();
      least_[i] = least_[i].array().max((way - reach_) / time);
      most_[i] = most_[i].array().min((way + reach_) / time);
    }
  }

  const std::vector<motion::OutlineKey>& keys_;
  double reach_;
  std::vector<Contour> least_, most_;
};

/// Whether keys are gone.
bool fit_keys(motion::AnimatedLayer& layer, double tolerance) {
  const std::vector<std::size_t> kept = KeyFit(layer.outline, tolerance).kept();
  if (kept.size() == layer.outline.size()) return false;
  std::vector<motion::OutlineKey> keys;
  for (const std::size_t k : kept) keys.push_back(std::move(layer.outline[k]));
  layer.outline = std::move(keys);
  return true;
}

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

/// A number behind a letter or another number, as short as SVG can have it.
void append_short(std::string& text, double value, const Decimals& decimals) {
  const std::string number = decimals.text(value);
  const bool is_negative = number.front() == '-';
  const std::size_t first = is_negative ? 1 : 0;
  const bool is_fraction = number.size() > first + 1 && number[first] == '0';
  if (text.back() != 'c' && !is_negative) text += ' ';
  if (is_negative) text += '-';
  text.append(number, is_fraction ? first + 1 : first);
}

/// The cubics of a contour, whose points are relative to the vertex before them as it is written, so that
/// roundings do not add up.
void append_cubics(std::string& text, const Contour& contour, bool is_closed,
                   const Decimals& decimals) {
  const auto written = [&](Eigen::Index row) {
    return Eigen::RowVector2d(decimals.rounded(contour(row, 0)), decimals.rounded(contour(row, 1)));
  };
  const Eigen::Index rows = contour.rows();
  text += 'c';
  Eigen::RowVector2d vertex = written(0);
  for (Eigen::Index row = 1; row < (is_closed ? rows + 1 : rows); ++row) {
    const Eigen::RowVector2d point = written(row % rows);
    append_short(text, point.x() - vertex.x(), decimals);
    append_short(text, point.y() - vertex.y(), decimals);
    if (row % 3 == 0) vertex = point;
  }
}

}  // namespace

AnimatedControlPoints control_points(const motion::Animation& animation, double tolerance) {
  motion::check_animation(animation);
  check_at_least("tolerance", tolerance, 0);
  AnimatedControlPoints result{animation, tolerance > 0};
  if (!result.cubic) return result;
  for (motion::AnimatedLayer& layer : result.animation.layers) {
    const bool keys_are_gone = layer.outline.size() > 2 && fit_keys(layer, tolerance / 2);
    fit(layer, keys_are_gone ? tolerance / 2 : tolerance);
  }
  return result;
}

std::string path_data(const std::vector<Contour>& contours, bool cubic, const Decimals& decimals,
                      const std::vector<bool>& open, Coordinates coordinates) {
  std::string text;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const Contour& contour = contours[i];
    const bool is_closed = i >= open.size() || !open[i];
    text += 'M';
    append_point(text, contour, 0, decimals);
    if (cubic && coordinates == Coordinates::relative) {
      append_cubics(text, contour, is_closed, decimals);
    } else {
      const Eigen::Index rows = contour.rows();
      // A polygon is closed by z; a cubic ends where it started.
      const Eigen::Index end = cubic && is_closed ? rows + 1 : rows;
      for (Eigen::Index row = 1; row < end; ++row) {
        text += row > 1 ? ' ' : cubic ? 'C' : 'L';
        append_point(text, contour, row % rows, decimals);
      }
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
