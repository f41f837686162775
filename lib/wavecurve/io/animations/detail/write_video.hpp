#pragma once

#include <filesystem>

#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// Writes a .gif, .mp4 (H.264) or .webm (VP9) by the ffmpeg program, which gets the rendered frames
/// over the background. Throws std::system_error if ffmpeg is missing or fails or the file cannot
/// be written, and as render_frames does; std::invalid_argument for another ending.
void write_video(const std::filesystem::path& path, const motion::Animation& animation,
                 const OutputOptions& options = {});

}  // namespace wavecurve::io
