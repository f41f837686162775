#pragma once

#include <filesystem>

#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// Writes a folder of images frame-0001.png, frame-0002.png, ..., transparent but for the options' background. It is made beside, and
/// then changes places with a folder of that name, if only plain files of such names are in that:
/// the frames are the old or the new ones at every moment, and a link to a folder stays a link.
/// Where the file system has no exchange, the old folder is called FOLDER.wavecurve-old in between,
/// and a run that finds one of this name with no FOLDER puts it back first. One run at a time.
/// Throws std::system_error naming the path, and as render_frames does.
void write_frames(const std::filesystem::path& folder, const motion::Animation& animation,
                  const OutputOptions& options = {});

}  // namespace wavecurve::io
