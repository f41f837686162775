#include "wavecurve/io/animations/write_animation.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

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

void write_svg(const std::filesystem::path& path, const motion::Animation& animation,
               const OutputOptions& options) {
  write_file(path, animated_svg(animation, options));
}

void write_lottie(const std::filesystem::path& path, const motion::Animation& animation,
                  const OutputOptions& options) {
  write_file(path, lottie(animation, options));
}

void write_page(const std::filesystem::path& path, const motion::Animation& animation,
                const OutputOptions& options) {
  write_file(path, html_player(animation, titled(path, options)));
}

constexpr AnimationFormat formats[] = {
    {".svg", "", true, write_svg},           {".json", "Lottie", true, write_lottie},
    {".html", "", true, write_page},         {".gif", "", false, write_video},
    {".mp4", "", false, write_video},        {".webm", "", false, write_video},
    {".png", "folder", false, write_frames},
};

/// None for an ending that is not known. A folder may be named with a slash at its end.
const AnimationFormat* format_of(const std::filesystem::path& path) {
  const std::string ending = (path.has_filename() ? path : path.parent_path()).extension().string();
  const auto* const found = std::ranges::find(formats, ending, &AnimationFormat::ending);
  return found == std::end(formats) ? nullptr : found;
}

}  // namespace

std::span<const AnimationFormat> animation_formats() { return formats; }

std::string animation_endings() {
  std::string text;
  for (const AnimationFormat& format : formats) {
    if (!text.empty()) text += ' ';
    text += format.ending;
    if (!format.remark.empty()) text += fmt::format(" ({})", format.remark);
  }
  return text;
}

void write_animation(const std::filesystem::path& path, const motion::Animation& animation,
                     const OutputOptions& options) {
  if (const AnimationFormat* format = format_of(path)) {
    return format->write(path, animation, options);
  }
  throw std::invalid_argument(fmt::format("cannot tell the format of {}: its ending is none of {}",
                                          path.string(), animation_endings()));
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
  const AnimationFormat* format = format_of(path);
  return format != nullptr && format->holds_curves;
}

double usual_tolerance(const std::filesystem::path& path, const ViewBox& box,
                       const OutputOptions& options) {
  return holds_curves(path) ? 0.1 / resolution(box, options) : 0;
}

}  // namespace wavecurve::io
