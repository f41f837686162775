#include "wavecurve/io/animations/lottie.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/animations/detail/control_points.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"

namespace wavecurve::io {

namespace {

/// From the drawing to Lottie's pixels and frames.
struct Target {
  ViewBox box;
  double scale = 1;
  double rate = 1;  ///< frames a second
  bool cubic = false;
  Decimals decimals = Decimals(3);

  Contour map(const Contour& contour) const {
    return (contour.rowwise() - Eigen::RowVector2d(box.x, box.y)) * scale;
  }
};

void append_pair(std::string& text, double x, double y, const Decimals& decimals) {
  text += text.back() == '[' ? "[" : ",[";
  decimals.append(text, x);
  text += ',';
  decimals.append(text, y);
  text += ']';
}

/// The vertices of a contour and its handles, which Lottie has relative to their vertices. They are
/// relative to the vertex as written, so that roundings do not add up.
std::string bezier(const Contour& contour, const Target& target) {
  const Contour points = target.map(contour);
  const Eigen::Index step = target.cubic ? 3 : 1, rows = points.rows();
  std::string vertices = "[", in = "[", out = "[";
  for (Eigen::Index row = 0; row < rows; row += step) {
    append_pair(vertices, points(row, 0), points(row, 1), target.decimals);
    Eigen::RowVector2d before = Eigen::RowVector2d::Zero(), after = before;
    if (target.cubic) {
      const Eigen::RowVector2d vertex(target.decimals.rounded(points(row, 0)),
                                      target.decimals.rounded(points(row, 1)));
      after = points.row(row + 1) - vertex;
      before = points.row((row + rows - 1) % rows) - vertex;
    }
    append_pair(in, before.x(), before.y(), target.decimals);
    append_pair(out, after.x(), after.y(), target.decimals);
  }
  return fmt::format("{{\"c\":true,\"v\":{}],\"i\":{}],\"o\":{}]}}", vertices, in, out);
}

/// What stands in a key for linear motion to the next.
constexpr std::string_view ease = ",\"i\":{\"x\":[1],\"y\":[1]},\"o\":{\"x\":[0],\"y\":[0]}";

/// A property: its value, or keys where the values differ. A key's value is a list, if need be in
/// brackets of its own.
std::string property(const std::vector<double>& times, const std::vector<std::string>& values,
                     const Target& target, bool in_brackets) {
  const auto changed = [&](const std::string& value) { return value != values.front(); };
  if (std::none_of(values.begin(), values.end(), changed)) {
    return fmt::format("{{\"a\":0,\"k\":{}}}", values.front());
  }
  const Decimals frame(4);
  std::string keys;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::string value = in_brackets ? "[" + values[k] + "]" : values[k];
    keys +=
        fmt::format("{}{{\"t\":{},\"s\":{}{}}}", k == 0 ? "" : ",",
                    frame.text(times[k] * target.rate), value, k + 1 == values.size() ? "" : ease);
  }
  return fmt::format("{{\"a\":1,\"k\":[{}]}}", keys);
}

std::string shape(const motion::AnimatedLayer& layer, std::size_t contour, const Target& target) {
  std::vector<double> times;
  std::vector<std::string> values;
  for (const motion::OutlineKey& key : layer.outline) {
    times.push_back(key.time);
    values.push_back(bezier(key.contours[contour], target));
  }
  return fmt::format("{{\"ty\":\"sh\",\"ks\":{}}},", property(times, values, target, true));
}

/// A property of the paint, whose text for one paint the function gives.
template <class Text>
std::string paint_property(const motion::AnimatedLayer& layer, const Target& target,
                           bool in_brackets, Text text) {
  std::vector<double> times;
  std::vector<std::string> values;
  for (const motion::PaintKey& key : layer.paint) {
    times.push_back(key.time);
    values.push_back(text(key.paint));
  }
  return property(times, values, target, in_brackets);
}

std::string lottie_colour(const Colour& value) {
  const Decimals share(4);
  return fmt::format("[{},{},{},1]", share.text(value.red), share.text(value.green),
                     share.text(value.blue));
}

std::string percent(double share) { return Decimals(1).text(100 * share); }

std::string fill(const motion::AnimatedLayer& layer, const Target& target) {
  const Paint& first = layer.paint.front().paint;
  if (!first.fill) return "";
  return fmt::format(
      "{{\"ty\":\"fl\",\"c\":{},\"o\":{},\"r\":{}}},",
      paint_property(layer, target, false, [](const Paint& p) { return lottie_colour(*p.fill); }),
      paint_property(layer, target, true, [](const Paint& p) { return percent(p.fill_opacity); }),
      first.fill_rule == FillRule::evenodd ? 2 : 1);
}

std::string stroke(const motion::AnimatedLayer& layer, const Target& target) {
  if (!layer.paint.front().paint.stroke) return "";
  return fmt::format(
      "{{\"ty\":\"st\",\"c\":{},\"o\":{},\"w\":{},\"lc\":2,\"lj\":2}},",
      paint_property(layer, target, false, [](const Paint& p) { return lottie_colour(*p.stroke); }),
      paint_property(layer, target, true, [](const Paint& p) { return percent(p.stroke_opacity); }),
      paint_property(layer, target, true, [&](const Paint& p) {
        return target.decimals.text(p.stroke_width * target.scale);
      }));
}

/// What transforms nothing; players expect it.
constexpr std::string_view identity =
    "\"o\":{\"a\":0,\"k\":100},\"r\":{\"a\":0,\"k\":0},\"p\":{\"a\":0,\"k\":[0,0]},"
    "\"a\":{\"a\":0,\"k\":[0,0]},\"s\":{\"a\":0,\"k\":[100,100]}";

/// Items of a group are painted from the last to the first, so the stroke stands before the fill.
std::string shape_layer(const motion::AnimatedLayer& layer, std::size_t index, int frames,
                        const Target& target) {
  std::string items;
  for (std::size_t i = 0; i < layer.outline.front().contours.size(); ++i) {
    items += shape(layer, i, target);
  }
  items += stroke(layer, target) + fill(layer, target);
  const std::string name = quoted(layer.id);
  return fmt::format(
      "{{\"ty\":4,\"nm\":{},\"ind\":{},\"ip\":0,\"op\":{},\"st\":0,\"ks\":{{{}}},\n"
      "\"shapes\":[{{\"ty\":\"gr\",\"nm\":{},\"it\":[{}{{\"ty\":\"tr\",{}}}]}}]}}",
      name, index, frames, identity, name, items, identity);
}

}  // namespace

std::string lottie(const motion::Animation& animation, const OutputOptions& options) {
  check_at_least("frames", options.frames, 2);
  const AnimatedControlPoints points = control_points(animation, options.tolerance);
  const ViewBox& box = animation.view_box;
  Target target{box, options.pixels / std::max(box.width, box.height),
                (options.frames - 1) / animation.duration, points.cubic};
  const double width = box.width * target.scale, height = box.height * target.scale;
  target.decimals = Decimals::for_box({0, 0, width, height}, options.accuracy);
  std::string layers;
  // The first layer of a Lottie animation is the uppermost.
  for (std::size_t i = animation.layers.size(); i-- > 0;) {
    layers += shape_layer(points.animation.layers[i], animation.layers.size() - i, options.frames,
                          target);
    if (i > 0) layers += ",\n";
  }
  return fmt::format(
      "{{\"v\":\"5.7.0\",\"fr\":{},\"ip\":0,\"op\":{},\"w\":{:.0f},\"h\":{:.0f},\"assets\":[],\n"
      "\"layers\":[{}]}}\n",
      fmt::format("{}", target.rate), options.frames, std::ceil(width - 1e-9),
      std::ceil(height - 1e-9), layers);
}

}  // namespace wavecurve::io
