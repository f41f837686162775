#include "wavecurve/io/write_animation.hpp"

#include <stdexcept>
#include <string>

#include "wavecurve/io/animated_svg.hpp"
#include "wavecurve/io/lottie.hpp"
#include "wavecurve/io/write_file.hpp"
#include "wavecurve/io/write_frames.hpp"
#include "wavecurve/io/write_video.hpp"

namespace wavecurve::io {

void write_animation(const std::filesystem::path& path, const Animation& animation,
                     const OutputOptions& options) {
  const std::string ending = path.extension().string();
  if (ending == ".svg") return write_file(path, animated_svg(animation, options));
  if (ending == ".json") return write_file(path, lottie(animation, options));
  if (ending == ".gif" || ending == ".mp4" || ending == ".webm") {
    return write_video(path, animation, options);
  }
  if (ending == ".png") return write_frames(path, animation, options);
  throw std::invalid_argument("cannot tell the format of " + path.string() +
                              ": its ending is none of .svg .json .html .gif .mp4 .webm .png");
}

}  // namespace wavecurve::io
