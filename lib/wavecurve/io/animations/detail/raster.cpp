#include "wavecurve/io/animations/detail/raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/animations/detail/coverage.hpp"
#include "wavecurve/io/drawings/detail/stroke_polygons.hpp"

namespace wavecurve::io {

namespace {

constexpr long most_pixels = 1L << 25;

/// Components multiplied by the opacity, as mixing wants them.
using Pixel = std::array<float, 4>;

/// An image under way.
struct Canvas {
  explicit Canvas(const RasterSize& its_size)
      : size(its_size),
        coverage(size.width, size.height),
        pixels(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {}

  RasterSize size;
  Coverage coverage;
  std::vector<Pixel> pixels;

  void paint(const std::vector<Contour>& polygons, FillRule rule, const Colour& colour,
             double opacity) {
    coverage.fill(polygons, rule);
    const auto channel = [](double value) {
      return static_cast<float>(std::clamp(value, 0.0, 1.0));
    };
    const Pixel source{channel(colour.red), channel(colour.green), channel(colour.blue), 1.0F};
    for (int y = coverage.first_row(); y < coverage.end_row(); ++y) {
      const float* shares = coverage.row(y);
      Pixel* row = pixels.data() + static_cast<std::ptrdiff_t>(y) * size.width;
      for (int x = coverage.first_column(); x < coverage.end_column(); ++x) {
        const float alpha = std::min(shares[x], 1.0F) * channel(opacity);
        if (alpha == 0) continue;
        for (std::size_t c = 0; c < 4; ++c) row[x][c] = alpha * source[c] + (1 - alpha) * row[x][c];
      }
    }
  }
};

/// From the drawing to pixels.
struct Placement {
  Placement(const ViewBox& box, const RasterSize& size)
      : scale(std::min(size.width / box.width, size.height / box.height)),
        x((size.width - scale * box.width) / 2 - scale * box.x),
        y((size.height - scale * box.height) / 2 - scale * box.y) {}

  std::vector<Contour> map(const std::vector<Contour>& contours) const {
    std::vector<Contour> result;
    for (const Contour& contour : contours) {
      result.emplace_back((scale * contour).rowwise() + Eigen::RowVector2d(x, y));
    }
    return result;
  }

  double scale, x, y;
};

/// To nearest, ties up; in double precision the sum with 1/2 is exact.
std::uint8_t byte(float value) {
  const float scaled = 255 * std::clamp(value, 0.0F, 1.0F);
  return static_cast<std::uint8_t>(static_cast<double>(scaled) + 0.5);
}

}  // namespace

RasterSize raster_size(const ViewBox& box, int pixels) {
  check_between("pixels", pixels, 2, 16384);
  const double scale = pixels / std::max(box.width, box.height);
  const auto even = [](double length) {
    return std::max(2, 2 * static_cast<int>(std::lround(length / 2)));
  };
  return {even(scale * box.width), even(scale * box.height)};
}

RasterSize raster_size(const ViewBox& box, const OutputOptions& options) {
  if (!options.size) return raster_size(box, options.pixels);
  const auto [width, height] = *options.size;
  check_between("the width of a picture", width, 2, 16384);
  check_between("the height of a picture", height, 2, 16384);
  check_between("the number of pixels of a picture", long{width} * height, 4, most_pixels);
  return *options.size;
}

double resolution(const ViewBox& box, const OutputOptions& options) {
  if (!options.size) return options.pixels / std::max(box.width, box.height);
  return std::min(options.size->width / box.width, options.size->height / box.height);
}

ViewBox framed(const ViewBox& box, const OutputOptions& options) {
  if (!options.size) return box;
  const double scale = resolution(box, options);
  const double width = options.size->width / scale, height = options.size->height / scale;
  return {box.x - (width - box.width) / 2, box.y - (height - box.height) / 2, width, height};
}

Raster over(Raster raster, const std::optional<Colour>& background) {
  if (!background) return raster;
  const double channels[3] = {background->red, background->green, background->blue};
  for (std::size_t i = 0; i < raster.rgba.size(); i += 4) {
    const double alpha = raster.rgba[i + 3] / 255.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = alpha * raster.rgba[i + c] + (1 - alpha) * 255 * channels[c];
      raster.rgba[i + c] = static_cast<std::uint8_t>(value + 0.5);
    }
    raster.rgba[i + 3] = 255;
  }
  return raster;
}

Raster render(const std::vector<motion::FrameLayer>& layers, const ViewBox& box,
              const RasterSize& size) {
  Canvas canvas(size);
  const Placement placement(box, size);
  for (const motion::FrameLayer& layer : layers) {
    const std::vector<Contour> polygons = placement.map(layer.contours);
    const Paint& paint = layer.paint;
    if (paint.fill) canvas.paint(polygons, paint.fill_rule, *paint.fill, paint.fill_opacity);
    if (paint.stroke && paint.stroke_width > 0) {
      const Pen pen{placement.scale * paint.stroke_width / 2, paint.line_cap, paint.line_join,
                    paint.miter_limit};
      canvas.paint(stroke_polygons(polygons, layer.open, pen), FillRule::nonzero, *paint.stroke,
                   paint.stroke_opacity);
    }
  }
  Raster raster{size.width, size.height, std::vector<std::uint8_t>(4 * canvas.pixels.size())};
  std::uint8_t* target = raster.rgba.data();
  for (const Pixel& pixel : canvas.pixels) {
    const float alpha = pixel[3], factor = alpha > 0 ? 1 / alpha : 0;
    for (std::size_t c = 0; c < 3; ++c) *target++ = byte(pixel[c] * factor);
    *target++ = byte(alpha);
  }
  return raster;
}

}  // namespace wavecurve::io
