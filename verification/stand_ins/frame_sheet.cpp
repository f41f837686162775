#include "verification/stand_ins/frame_sheet.hpp"

#include <fmt/format.h>

#include "wavecurve/io/animations/detail/control_points.hpp"
#include "wavecurve/io/drawings/detail/svg_paint.hpp"

namespace wavecurve::verification {

namespace {

constexpr double cell = 150, gap = 8, label_width = 56, title_height = 24;

std::string layers_svg(const std::vector<motion::FrameLayer>& layers,
                       const io::Decimals& decimals) {
  std::string svg;
  for (const motion::FrameLayer& layer : layers) {
    svg += "<path";
    for (const auto& [name, value] : io::svg_paint(layer.paint)) {
      svg += fmt::format(" {}=\"{}\"", name, value);
    }
    svg += fmt::format(" d=\"{}\"/>\n", io::path_data(layer.contours, false, decimals));
  }
  return svg;
}

}  // namespace

std::string frame_sheet(const std::vector<SheetRow>& rows, const std::vector<std::string>& columns,
                        const ViewBox& box, double ground) {
  const io::Decimals decimals = io::Decimals::for_box(box, 5e-4);
  const double height = cell * box.height / box.width;
  std::size_t most = columns.size();
  std::string svg;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    svg += fmt::format("<text x=\"{:.2f}\" y=\"17\" text-anchor=\"middle\">{}</text>\n",
                       label_width + (static_cast<double>(j) + 0.5) * (cell + gap), columns[j]);
  }
  double y = columns.empty() ? gap : title_height;
  for (const SheetRow& row : rows) {
    most = std::max(most, row.frames.size());
    svg += fmt::format("<text x=\"{}\" y=\"{:.2f}\">{}</text>\n", gap, y + height / 2, row.label);
    for (std::size_t j = 0; j < row.frames.size(); ++j) {
      svg += fmt::format(
          "<svg x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
          "viewBox=\"{} {} {} {}\">\n<path d=\"M{} {}h{}\" stroke=\"#888888\" "
          "stroke-width=\"{:.2f}\"/>\n{}</svg>\n",
          label_width + static_cast<double>(j) * (cell + gap), y, cell, height, box.x, box.y,
          box.width, box.height, box.x, ground, box.width, box.width / cell,
          layers_svg(row.frames[j], decimals));
    }
    y += height + gap;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.2f} {1:.2f}\" "
      "width=\"{0:.2f}\" height=\"{1:.2f}\" font-family=\"sans-serif\" font-size=\"13\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{2}</svg>\n",
      label_width + static_cast<double>(most) * (cell + gap), y, svg);
}

}  // namespace wavecurve::verification
