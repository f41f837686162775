#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/morph/morph.hpp"

namespace wavecurve::io {

/// A format in which an animation leaves.
struct AnimationFormat {
  std::string_view ending;  ///< ".svg"
  std::string_view remark;  ///< what it is, where the ending does not say it; else empty
  bool holds_curves;        ///< there is a tolerance for them; the others hold frames
  void (*write)(const std::filesystem::path& path, const motion::Animation& animation,
                const OutputOptions& options);
};

/// All of them; to add one, add a row there.
std::span<const AnimationFormat> animation_formats();

/// ".svg .json (Lottie)" and so on, for help and messages.
std::string animation_endings();

/// Writes an animation in the format of the path's ending, one of animation_formats(). An .html is
/// a player, a .png a folder of frames frame-0001.png, ...; a .gif, .mp4 or .webm is written by the
/// ffmpeg program. Throws std::invalid_argument for another ending, as check_animation does, and
/// std::system_error where the file cannot be written or ffmpeg is missing; what was there before
/// is then as it was.
void write_animation(const std::filesystem::path& path, const motion::Animation& animation,
                     const OutputOptions& options = {});

/// The same for a morph, whose .html lets the viewer choose the scale.
void write_animation(const std::filesystem::path& path, const motion::Morph& morph,
                     const OutputOptions& options = {});

/// Whether the format of that ending holds curves; false of an unknown ending.
bool holds_curves(const std::filesystem::path& path);

/// The tolerance that does not show: a tenth of a pixel of a drawing of this box at the output's size, where the file holds
/// curves; else 0.
double usual_tolerance(const std::filesystem::path& path, const ViewBox& box,
                       const OutputOptions& options);

}  // namespace wavecurve::io
