#pragma once

#include <string>
#include <vector>

#include "wavecurve/motion/animation.hpp"

namespace wavecurve::verification {

/// Pictures of one row of a sheet, in the order of time.
struct SheetRow {
  std::string label;
  std::vector<std::vector<motion::FrameLayer>> frames;
};

/// An SVG of rows of drawings, each in the same view box, with titles over the columns (none, if
/// there are none) and a line for the ground at a height of the view box.
std::string frame_sheet(const std::vector<SheetRow>& rows, const std::vector<std::string>& columns,
                        const ViewBox& box, double ground);

}  // namespace wavecurve::verification
