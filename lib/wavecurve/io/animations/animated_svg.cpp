#include "wavecurve/io/animations/animated_svg.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/io/animations/detail/control_points.hpp"
#include "wavecurve/io/drawings/detail/svg_paint.hpp"
#include "wavecurve/io/files/detail/xml_escaped.hpp"

namespace wavecurve::io {

namespace {

/// The values of one attribute at the times of its keys, as shares of the duration.
struct Track {
  std::string attribute;
  std::vector<double> times;
  std::vector<std::string> values;

  void add(double time, std::string value) {
    times.push_back(std::min(time, 1.0));
    values.push_back(std::move(value));
  }
};

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
      "<animate attributeName=\"{}\" dur=\"{:.6g}s\" {} keyTimes=\"{}\" values=\"{}\"/>\n",
      track.attribute, duration, loop ? "repeatCount=\"indefinite\"" : "fill=\"freeze\"", times,
      joined(track.values));
}

Track outline_track(const motion::AnimatedLayer& layer, double duration, bool cubic,
                    const Decimals& decimals) {
  Track track{"d", {}, {}};
  for (const motion::OutlineKey& key : layer.outline) {
    track.add(key.time / duration, path_data(key.contours, cubic, decimals));
  }
  return track;
}

std::vector<Track> paint_tracks(const motion::AnimatedLayer& layer, double duration) {
  std::vector<Track> tracks;
  for (const auto& [name, value] : svg_paint(layer.paint.front().paint)) {
    tracks.push_back({name, {}, {}});
  }
  for (const motion::PaintKey& key : layer.paint) {
    const auto attributes = svg_paint(key.paint);
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      tracks[i].add(key.time / duration, attributes[i].second);
    }
  }
  return tracks;
}

std::string path(const motion::AnimatedLayer& layer, const AnimatedControlPoints& points,
                 const Decimals& decimals, bool loop) {
  const double duration = points.animation.duration;
  std::vector<Track> tracks = paint_tracks(layer, duration);
  tracks.push_back(outline_track(layer, duration, points.cubic, decimals));
  std::string attributes, animations;
  for (const Track& track : tracks) {
    attributes += fmt::format(" {}=\"{}\"", track.attribute, track.values.front());
    animations += animate(track, duration, loop);
  }
  return fmt::format("<path id=\"{}\"{}>\n{}</path>\n", xml_escaped(layer.id), attributes,
                     animations);
}

}  // namespace

std::string animated_svg(const motion::Animation& animation, const OutputOptions& options) {
  const AnimatedControlPoints points = control_points(animation, options.tolerance);
  const ViewBox& box = animation.view_box;
  const Decimals decimals = Decimals::for_box(box, options.accuracy);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\">\n", decimals.text(box.x),
      decimals.text(box.y), decimals.text(box.width), decimals.text(box.height));
  for (const motion::AnimatedLayer& layer : points.animation.layers) {
    svg += path(layer, points, decimals, options.loop);
  }
  return svg + "</svg>\n";
}

}  // namespace wavecurve::io
