#include "wavecurve/io/animations/detail/render_frames.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/motion/detail/check_animation.hpp"

namespace wavecurve::io {

void render_frames(const motion::Animation& animation, const OutputOptions& options,
                   const std::function<void(const Raster&)>& take) {
  motion::check_animation(animation);
  check_at_least("frames", options.frames, 2);
  const RasterSize size = raster_size(animation.view_box, options);
  for (int i = 0; i < options.frames; ++i) {
    const double time = animation.duration * i / (options.frames - 1);
    take(render(motion::frame_at(animation, time), animation.view_box, size));
    if (options.progress) options.progress(i + 1, options.frames);
  }
}

}  // namespace wavecurve::io
