#pragma once

#include <filesystem>

#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/morph/morph.hpp"

namespace wavecurve::io {

/// Writes an animation in the format of the path's ending: .svg (animated), .json (Lottie), .html
/// (a player), .gif, .mp4, .webm (by the ffmpeg program), .png (a folder of that name, of frames
/// frame-0001.png, ...). Throws std::invalid_argument for another ending, as check_animation does,
/// and std::system_error where the file cannot be written or ffmpeg is missing; what was there
/// before is then as it was.
void write_animation(const std::filesystem::path& path, const motion::Animation& animation,
                     const OutputOptions& options = {});

/// The same for a morph, whose .html lets the viewer choose the scale.
void write_animation(const std::filesystem::path& path, const motion::Morph& morph,
                     const OutputOptions& options = {});

/// True of .svg, .json and .html, which hold curves, for which there is a tolerance.
bool holds_curves(const std::filesystem::path& path);

/// The tolerance that does not show: a tenth of a pixel of a drawing of this box at the output's size, where the file holds
/// curves; else 0.
double usual_tolerance(const std::filesystem::path& path, const ViewBox& box,
                       const OutputOptions& options);

}  // namespace wavecurve::io
