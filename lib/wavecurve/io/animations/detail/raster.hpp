#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// An image: red, green, blue and opacity (not multiplied in) of 8 bits, rows from the top.
struct Raster {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Width and height of frames whose longer side is `pixels`, rounded to even numbers, for video
/// wants them. Throws std::invalid_argument unless 2 <= pixels <= 16384.
RasterSize raster_size(const ViewBox& box, int pixels);

/// The size of the options, or as above by their pixels. Throws std::invalid_argument unless each side
/// is 2 to 16384 and both together are at most 2^25 pixels, an image of half a gibibyte.
RasterSize raster_size(const ViewBox& box, const OutputOptions& options);

/// Pixels a unit of the drawing.
double resolution(const ViewBox& box, const OutputOptions& options);

/// The box with the aspect of the options' size: what is missing is added at both sides alike.
ViewBox framed(const ViewBox& box, const OutputOptions& options);

/// Draws the layers one over the other, the first lowest: fills, then strokes,
/// mixed in sRGB as browsers do, antialiased by the share of a pixel's area that is covered (exact
/// along each of 16 scan lines a pixel). The view box is centred in the image, its aspect kept.
Raster render(const std::vector<motion::FrameLayer>& layers, const ViewBox& box,
              const RasterSize& size);

/// The image before a background of one colour, where there is one: opaque.
Raster over(Raster raster, const std::optional<Colour>& background);

}  // namespace wavecurve::io
