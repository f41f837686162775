#pragma once

#include <cstdint>
#include <vector>

#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// An image: red, green, blue and opacity (not multiplied in) of 8 bits, rows from the top.
struct Raster {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Width and height of frames whose longer side is `pixels`, rounded to even numbers, for video
/// wants them. Throws std::invalid_argument unless 2 <= pixels <= 16384.
struct RasterSize {
  int width = 0, height = 0;
};
RasterSize raster_size(const ViewBox& box, int pixels);

/// Draws the layers one over the other, the first lowest: fills, then strokes,
/// mixed in sRGB as browsers do, antialiased by the share of a pixel's area that is covered (exact
/// along each of 16 scan lines a pixel). The view box is centred in the image, its aspect kept.
Raster render(const std::vector<motion::FrameLayer>& layers, const ViewBox& box,
              const RasterSize& size);

}  // namespace wavecurve::io
