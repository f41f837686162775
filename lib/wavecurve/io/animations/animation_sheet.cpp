#include "wavecurve/io/animations/animation_sheet.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/animations/detail/control_points.hpp"
#include "wavecurve/io/drawings/detail/svg_paint.hpp"

namespace wavecurve::io {

namespace {

constexpr double sheet_side = 160;  ///< of the longer edge of a frame, in user units
constexpr double gap = 16, caption = 22;

/// As many columns as make the last row full, if one number not far from square does.
int columns_of(int frames) {
  const int square = static_cast<int>(std::ceil(std::sqrt(frames)));
  for (int columns = square; columns <= 2 * square; ++columns) {
    if (frames % columns == 0) return columns;
  }
  return square;
}

}  // namespace

std::string animation_sheet(const motion::Animation& animation, const OutputOptions& options) {
  check_at_least("frames", options.frames, 2);
  const AnimatedControlPoints points = control_points(animation, options.tolerance);
  const ViewBox& box = animation.view_box;
  const Decimals decimals = Decimals::for_box(box, options.accuracy);
  const double scale = sheet_side / std::max(box.width, box.height);
  const double width = scale * box.width, height = scale * box.height;
  const int columns = columns_of(options.frames);
  const int rows = (options.frames + columns - 1) / columns;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{0} frames, to be read "
      "from left to right and from top to bottom\" viewBox=\"0 0 {1:.2f} {2:.2f}\" "
      "width=\"{1:.2f}\" height=\"{2:.2f}\" font-family=\"sans-serif\" font-size=\"13\">\n",
      options.frames, gap + columns * (width + gap), gap + rows * (height + caption + gap));
  if (options.background || !options.transparent) {
    svg += fmt::format("<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
                       options.background ? hex_colour(*options.background) : "white");
  }
  for (int i = 0; i < options.frames; ++i) {
    const double tau = static_cast<double>(i) / (options.frames - 1);
    const double x = gap + i % columns * (width + gap);
    const double y = gap + i / columns * (height + caption + gap);
    svg += fmt::format(
        "<svg x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
        "viewBox=\"{} {} {} {}\">\n{}</svg>\n",
        x, y, width, height, decimals.text(box.x), decimals.text(box.y), decimals.text(box.width),
        decimals.text(box.height),
        layers_svg(motion::frame_at(points.animation, tau * animation.duration), points.cubic,
                   decimals));
    svg +=
        fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">\u03c4 = {}</text>\n",
                    x + width / 2, y + height + 16, Decimals(3).text(tau));
  }
  return svg + "</svg>\n";
}

}  // namespace wavecurve::io
