#pragma once

#include <string>
#include <vector>

#include "wavecurve/curves/contour.hpp"

namespace wavecurve::verification {

/// One row of frames, in the order of time.
struct FrameRow {
  std::string label;
  std::vector<Contour> frames;
};

/// An SVG of rows of outlines, one column a time, all in the same scale and each cell around the
/// same place; in grey behind each frame the rest shape. y points up, as in the publication's
/// formulas.
std::string frame_grid(const std::vector<FrameRow>& rows, const std::vector<std::string>& columns,
                       const Contour& rest);

}  // namespace wavecurve::verification
