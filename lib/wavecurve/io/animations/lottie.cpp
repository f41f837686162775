#include "wavecurve/io/animations/lottie.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/animations/detail/control_points.hpp"
#include "wavecurve/io/animations/detail/painting_slots.hpp"
#include "wavecurve/io/animations/detail/raster.hpp"
#include "wavecurve/io/drawings/detail/svg_paint.hpp"
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
std::string bezier(const Contour& contour, bool open, const Target& target) {
  const Contour points = target.map(contour);
  const Eigen::Index step = target.cubic ? 3 : 1, rows = points.rows();
  std::string vertices = "[", in = "[", out = "[";
  for (Eigen::Index row = 0; row < rows; row += step) {
    append_pair(vertices, points(row, 0), points(row, 1), target.decimals);
    Eigen::RowVector2d before = Eigen::RowVector2d::Zero(), after = before;
    if (target.cubic) {
      const Eigen::RowVector2d vertex(target.decimals.rounded(points(row, 0)),
                                      target.decimals.rounded(points(row, 1)));
      if (!open || row + 1 < rows) after = points.row(row + 1) - vertex;
      if (!open || row > 0) before = points.row((row + rows - 1) % rows) - vertex;
    }
    append_pair(in, before.x(), before.y(), target.decimals);
    append_pair(out, after.x(), after.y(), target.decimals);
  }
  return fmt::format("{{\"c\":{},\"v\":{}],\"i\":{}],\"o\":{}]}}", !open, vertices, in, out);
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
    values.push_back(bezier(key.contours[contour], is_open(layer, contour), target));
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

std::string fill(const motion::AnimatedLayer& layer, const Paint& style, const Target& target) {
  return fmt::format(
      "{{\"ty\":\"fl\",\"c\":{},\"o\":{},\"r\":{}}}",
      paint_property(layer, target, false, [](const Paint& p) { return lottie_colour(*p.fill); }),
      paint_property(layer, target, true, [](const Paint& p) { return percent(p.fill_opacity); }),
      style.fill_rule == FillRule::evenodd ? 2 : 1);
}

/// What Lottie calls caps and joins by number.
int number_of(LineCap cap) { return cap == LineCap::butt ? 1 : cap == LineCap::round ? 2 : 3; }
int number_of(LineJoin join) {
  return join == LineJoin::miter ? 1 : join == LineJoin::round ? 2 : 3;
}

/// Keys that keep their value until the next: percents at times in frames.
std::string held(const std::vector<std::pair<double, int>>& keys) {
  if (keys.size() == 1) return fmt::format("{{\"a\":0,\"k\":{}}}", keys.front().second);
  std::string text;
  for (const auto& [time, value] : keys) {
    text += fmt::format("{}{{\"t\":{},\"s\":[{}],\"h\":1}}", text.empty() ? "" : ",",
                        Decimals(4).text(time), value);
  }
  return fmt::format("{{\"a\":1,\"k\":[{}]}}", text);
}

std::string stroke(const motion::AnimatedLayer& layer, const Paint& style, const Target& target) {
  return fmt::format(
      "{{\"ty\":\"st\",\"c\":{},\"o\":{},\"w\":{},\"lc\":{},\"lj\":{},\"ml\":{}}}",
      paint_property(layer, target, false, [](const Paint& p) { return lottie_colour(*p.stroke); }),
      paint_property(layer, target, true, [](const Paint& p) { return percent(p.stroke_opacity); }),
      paint_property(
          layer, target, true,
          [&](const Paint& p) { return target.decimals.text(p.stroke_width * target.scale); }),
      number_of(style.line_cap), number_of(style.line_join), Decimals(3).text(style.miter_limit));
}

bool have_one_style(const Paint& a, const Paint& b) {
  return a.line_cap == b.line_cap && a.line_join == b.line_join && a.fill_rule == b.fill_rule;
}

/// Caps, joins and the fill rule do not move in Lottie: one group for each style, shown in its time.
struct StyleRun {
  Paint style;
  std::vector<std::pair<double, int>> shown;  ///< percents at times in frames
};

std::vector<StyleRun> style_runs(const motion::AnimatedLayer& layer, const Target& target) {
  std::vector<StyleRun> runs;
  for (const motion::PaintKey& key : layer.paint) {
    const double time = runs.empty() ? 0 : key.time * target.rate;
    const auto same = [&](const StyleRun& run) { return have_one_style(run.style, key.paint); };
    auto found = std::ranges::find_if(runs, same);
    if (found == runs.end()) {
      runs.push_back({key.paint, {{0, 0}}});
      found = runs.end() - 1;
    }
    for (auto run = runs.begin(); run != runs.end(); ++run) {
      const int value = run == found ? 100 : 0;
      if (run->shown.back().second == value) continue;
      if (run->shown.back().first == time) run->shown.pop_back();
      run->shown.emplace_back(time, value);
    }
  }
  return runs;
}

/// What transforms nothing; players expect it. The opacity stands apart.
constexpr std::string_view identity =
    "\"r\":{\"a\":0,\"k\":0},\"p\":{\"a\":0,\"k\":[0,0]},\"a\":{\"a\":0,\"k\":[0,0]},"
    "\"s\":{\"a\":0,\"k\":[100,100]}";

/// Items of a group are painted from the last to the first, so the stroke stands before the fill.
std::string group(const motion::AnimatedLayer& layer, const StyleRun& run, const Target& target) {
  std::string items;
  for (std::size_t i = 0; i < layer.outline.front().contours.size(); ++i) {
    items += shape(layer, i, target);
  }
  const Paint& first = layer.paint.front().paint;
  if (first.stroke) items += stroke(layer, run.style, target) + ",";
  if (first.fill) items += fill(layer, run.style, target) + ",";
  return fmt::format("{{\"ty\":\"gr\",\"nm\":{},\"it\":[{}{{\"ty\":\"tr\",\"o\":{},{}}}]}}",
                     quoted(layer.id), items, held(run.shown), identity);
}

/// When a slot is shown, as percents at times in frames.
std::vector<std::pair<double, int>> slot_keys(const PaintingSlot& slot,
                                              const motion::Animation& animation,
                                              const Target& target) {
  std::vector<std::pair<double, int>> keys;
  for (std::size_t k = 0; k < slot.is_shown.size(); ++k) {
    const int value = slot.is_shown[k] ? 100 : 0;
    if (!keys.empty() && keys.back().second == value) continue;
    keys.emplace_back(k == 0 ? 0 : animation.order[k - 1].time * target.rate, value);
  }
  return keys;
}

std::string shape_layer(const motion::Animation& animation, const PaintingSlot& slot,
                        std::size_t index, int frames, const Target& target) {
  const motion::AnimatedLayer& layer = animation.layers[slot.layer];
  std::string groups;
  for (const StyleRun& run : style_runs(layer, target)) {
    if (!groups.empty()) groups += ',';
    groups += group(layer, run, target);
  }
  return fmt::format(
      "{{\"ty\":4,\"nm\":{},\"ind\":{},\"ip\":0,\"op\":{},\"st\":0,\"ks\":{{\"o\":{},{}}},\n"
      "\"shapes\":[{}]}}",
      quoted(layer.id), index, frames, held(slot_keys(slot, animation, target)), identity, groups);
}

}  // namespace

std::string lottie(const motion::Animation& animation, const OutputOptions& options) {
  check_at_least("frames", options.frames, 2);
  const AnimatedControlPoints points = control_points(animation, options.tolerance);
  const ViewBox box = framed(animation.view_box, options);
  Target target{box, resolution(box, options), (options.frames - 1) / animation.duration,
                points.cubic};
  const double width = box.width * target.scale, height = box.height * target.scale;
  target.decimals = Decimals::for_box({0, 0, width, height}, options.accuracy);
  std::string layers;
  // The first layer of a Lottie animation is the uppermost.
  const std::vector<PaintingSlot> slots = painting_slots(animation);
  for (std::size_t i = slots.size(); i-- > 0;) {
    layers += shape_layer(points.animation, slots[i], slots.size() - i, options.frames, target);
    if (i > 0) layers += ",\n";
  }
  if (options.background) {
    layers += fmt::format(
        ",\n{{\"ty\":1,\"nm\":\"background\",\"ind\":{},\"ip\":0,\"op\":{},\"st\":0,"
        "\"ks\":{{\"o\":{{\"a\":0,\"k\":100}},{}}},\"sc\":\"{}\",\"sw\":{:.0f},\"sh\":{:.0f}}}",
        slots.size() + 1, options.frames, identity, hex_colour(*options.background),
        std::ceil(width - 1e-9), std::ceil(height - 1e-9));
  }
  return fmt::format(
      "{{\"v\":\"5.7.0\",\"fr\":{},\"ip\":0,\"op\":{},\"w\":{:.0f},\"h\":{:.0f},\"assets\":[],\n"
      "\"layers\":[{}]}}\n",
      fmt::format("{}", target.rate), options.frames, std::ceil(width - 1e-9),
      std::ceil(height - 1e-9), layers);
}

}  // namespace wavecurve::io
