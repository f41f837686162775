#include "wavecurve/io/animations/write_animation.hpp"

#include <stdexcept>
#include <string>

#include "wavecurve/io/animations/animated_svg.hpp"
#include "wavecurve/io/animations/detail/html_player.hpp"
#include "wavecurve/io/animations/detail/raster.hpp"
#include "wavecurve/io/animations/detail/write_frames.hpp"
#include "wavecurve/io/animations/detail/write_video.hpp"
#include "wavecurve/io/animations/lottie.hpp"
#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/motion/there_and_back.hpp"

namespace wavecurve::io {

namespace {

OutputOptions titled(const std::filesystem::path& path, const OutputOptions& options) {
  OutputOptions result = options;
  if (result.title.empty()) result.title = path.stem().string();
  return result;
}

}  // namespace

void write_animation(const std::filesystem::path& path, const motion::Animation& animation,
                     const OutputOptions& options) {
  // A folder may be named with a slash at its end.
  const std::string ending = (path.has_filename() ? path : path.parent_path()).extension().string();
  if (ending == ".svg") return write_file(path, animated_svg(animation, options));
  if (ending == ".json") return write_file(path, lottie(animation, options));
  if (ending == ".html") {
    return write_file(path, html_player(animation, titled(path, options)));
  }
  if (ending == ".gif" || ending == ".mp4" || ending == ".webm") {
    return write_video(path, animation, options);
  }
  if (ending == ".png") return write_frames(path, animation, options);
  throw std::invalid_argument("cannot tell the format of " + path.string() +
                              ": its ending is none of .svg .json .html .gif .mp4 .webm .png");
}

void write_animation(const std::filesystem::path& path, const motion::Morph& morph,
                     const OutputOptions& options) {
  if (path.extension() == ".html") {
    return write_file(path, html_player(morph, titled(path, options)));
  }
  if (!options.loop) return write_animation(path, motion::animate(morph), options);
  OutputOptions both_ways = options;  // at the same rate
  both_ways.frames = 2 * options.frames - 1;
  write_animation(path, motion::there_and_back(motion::animate(morph)), both_ways);
}

bool holds_curves(const std::filesystem::path& path) {
  const std::filesystem::path ending = path.extension();
  return ending == ".svg" || ending == ".json" || ending == ".html";
}

double usual_tolerance(const std::filesystem::path& path, const ViewBox& box,
                       const OutputOptions& options) {
  return holds_curves(path) ? 0.1 / resolution(box, options) : 0;
}

}  // namespace wavecurve::io
