#include "wavecurve/io/animations/animated_svg.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/io/animations/detail/control_points.hpp"
#include "wavecurve/io/animations/detail/painting_slots.hpp"
#include "wavecurve/io/animations/detail/raster.hpp"
#include "wavecurve/io/drawings/detail/svg_paint.hpp"
#include "wavecurve/io/files/detail/xml_escaped.hpp"

namespace wavecurve::io {

namespace {

/// The values of one attribute at the times of its keys, as shares of the duration.
struct Track {
  std::string attribute;
  std::vector<double> times = {};
  std::vector<std::string> values = {};

  void add(double time, std::string value) {
    times.push_back(std::min(time, 1.0));
    values.push_back(std::move(value));
  }
};

/// Attributes whose values are words keep one until the next key.
bool is_discrete(const std::string& attribute) {
  return attribute == "visibility" || attribute == "fill-rule" || attribute == "stroke-linecap" ||
         attribute == "stroke-linejoin";
}

std::string joined(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ";") + value;
  return text;
}

/// The animate element of a track, or nothing where it does not change. SMIL wants the times to
/// begin with 0 and to end with 1.
std::string animate(Track track, double duration, bool loop) {
  const auto changed = [&](const std::string& value) { return value != track.values.front(); };
  if (std::none_of(track.values.begin(), track.values.end(), changed)) return "";
  if (track.times.front() > 0) {
    track.times.insert(track.times.begin(), 0);
    track.values.insert(track.values.begin(), track.values.front());
  }
  if (track.times.back() < 1) track.add(1, track.values.back());
  const Decimals share(6);
  std::string times;
  for (double time : track.times) {
    if (!times.empty()) times += ';';
    times += share.text(time);
  }
  return fmt::format(
      "<animate attributeName=\"{}\"{} dur=\"{:.6g}s\" {} keyTimes=\"{}\" values=\"{}\"/>\n",
      track.attribute, is_discrete(track.attribute) ? " calcMode=\"discrete\"" : "", duration,
      loop ? "repeatCount=\"indefinite\"" : "fill=\"freeze\"", times, joined(track.values));
}

Track outline_track(const motion::AnimatedLayer& layer, double duration, bool cubic,
                    const Decimals& decimals) {
  Track track{"d"};
  for (const motion::OutlineKey& key : layer.outline) {
    track.add(key.time / duration, path_data(key.contours, cubic, decimals, layer.open));
  }
  return track;
}

std::vector<Track> paint_tracks(const motion::AnimatedLayer& layer, double duration) {
  std::vector<Track> tracks;
  for (const auto& [name, value] : svg_paint(layer.paint.front().paint)) {
    tracks.push_back({name});
  }
  for (const motion::PaintKey& key : layer.paint) {
    const auto attributes = svg_paint(key.paint);
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      tracks[i].add(key.time / duration, attributes[i].second);
    }
  }
  return tracks;
}

/// When a slot of several orders is shown.
Track visibility_track(const PaintingSlot& slot, const motion::Animation& animation) {
  Track track{"visibility"};
  for (std::size_t k = 0; k < slot.is_shown.size(); ++k) {
    if (k == 1 && animation.order.front().time == 0) continue;  // as order 0
    const double time = k == 0 ? 0 : animation.order[k - 1].time;
    track.add(time / animation.duration, slot.is_shown[k] ? "visible" : "hidden");
  }
  return track;
}

std::string path(const std::string& id, const PaintingSlot& slot,
                 const AnimatedControlPoints& points, const Decimals& decimals, bool loop) {
  const motion::AnimatedLayer& layer = points.animation.layers[slot.layer];
  const double duration = points.animation.duration;
  std::vector<Track> tracks = paint_tracks(layer, duration);
  if (!slot.is_always_shown()) tracks.push_back(visibility_track(slot, points.animation));
  tracks.push_back(outline_track(layer, duration, points.cubic, decimals));
  std::string attributes, animations;
  for (const Track& track : tracks) {
    attributes += fmt::format(" {}=\"{}\"", track.attribute, track.values.front());
    animations += animate(track, duration, loop);
  }
  return fmt::format("<path id=\"{}\"{}>\n{}</path>\n", xml_escaped(id), attributes, animations);
}

/// Gives the first slot of a layer the layer's id, and the others one of their own.
class SlotIds {
 public:
  explicit SlotIds(const motion::Animation& animation) {
    for (const motion::AnimatedLayer& layer : animation.layers) taken_.insert(layer.id);
  }
  std::string of(const PaintingSlot& slot, const motion::Animation& animation) {
    std::string id = animation.layers[slot.layer].id;
    if (layers_.insert(slot.layer).second) return id;
    for (int number = 2;; ++number) {
      const std::string other = fmt::format("{}-{}", id, number);
      if (taken_.insert(other).second) return other;
    }
  }

 private:
  std::set<std::string> taken_;
  std::set<std::size_t> layers_;
};

}  // namespace

std::string animated_svg(const motion::Animation& animation, const OutputOptions& options) {
  const AnimatedControlPoints points = control_points(animation, options.tolerance);
  const ViewBox box = framed(animation.view_box, options);
  const Decimals decimals = Decimals::for_box(box, options.accuracy);
  const std::string place[] = {decimals.text(box.x), decimals.text(box.y), decimals.text(box.width),
                               decimals.text(box.height)};
  std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{}\"",
                                fmt::join(place, " "));
  if (options.size) {
    svg += fmt::format(" width=\"{}\" height=\"{}\"", options.size->width, options.size->height);
  }
  svg += ">\n";
  if (options.background) {
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                       place[0], place[1], place[2], place[3], hex_colour(*options.background));
  }
  SlotIds ids(animation);
  for (const PaintingSlot& slot : painting_slots(animation)) {
    svg += path(ids.of(slot, animation), slot, points, decimals, options.loop);
  }
  return svg + "</svg>\n";
}

}  // namespace wavecurve::io
