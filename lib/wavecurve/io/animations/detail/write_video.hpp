#pragma once

#include <filesystem>

#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// Writes a .gif, .mp4 (H.264) or .webm (VP9) by the ffmpeg program, which gets the rendered frames
/// over the background, or as they are; the same bytes on any number of processors. The video is made beside the
/// target, and takes its place once ffmpeg ended without a complaint, ffprobe decoded it to the
/// number of frames, and it was synced. Throws std::system_error if one of the programs is missing
/// or fails or the file cannot be written, and as render_frames does; std::invalid_argument for
/// another ending, and for what a format does not have: a transparent .mp4, an odd number of pixels in
/// .mp4 and .webm, more than 100 frames a second in a .gif. What was there before is then as it was.
void write_video(const std::filesystem::path& path, const motion::Animation& animation,
                 const OutputOptions& options = {});

}  // namespace wavecurve::io
