#pragma once

#include <filesystem>

#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// Writes a folder of transparent images frame-0001.png, frame-0002.png, ... It is made beside and
/// renamed, whole or not at all; a folder of the same name is replaced if there are only such
/// images in it. Throws std::system_error naming the path, and as render_frames does.
void write_frames(const std::filesystem::path& folder, const motion::Animation& animation,
                  const OutputOptions& options = {});

}  // namespace wavecurve::io
