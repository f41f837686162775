#include "verification/stand_ins/frame_sheet.hpp"

#include <fmt/format.h>

#include "wavecurve/io/animations/detail/control_points.hpp"
#include "wavecurve/io/drawings/detail/svg_paint.hpp"

namespace wavecurve::verification {

namespace {

constexpr double sheet_cell = 150, sheet_gap = 8, sheet_label_width = 56, sheet_title_height = 24;

}  // namespace

std::string frame_sheet(const std::vector<SheetRow>& rows, const std::vector<std::string>& columns,
                        const ViewBox& box, double ground) {
  const io::Decimals decimals = io::Decimals::for_box(box, 5e-4);
  const double height = sheet_cell * box.height / box.width;
  std::size_t most = columns.size();
  std::string svg;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    svg += fmt::format(
        "<text x=\"{:.2f}\" y=\"17\" text-anchor=\"middle\">{}</text>\n",
        sheet_label_width + (static_cast<double>(j) + 0.5) * (sheet_cell + sheet_gap), columns[j]);
  }
  double y = columns.empty() ? sheet_gap : sheet_title_height;
  for (const SheetRow& row : rows) {
    most = std::max(most, row.frames.size());
    svg += fmt::format("<text x=\"{}\" y=\"{:.2f}\">{}</text>\n", sheet_gap, y + height / 2,
                       row.label);
    for (std::size_t j = 0; j < row.frames.size(); ++j) {
      svg += fmt::format(
          "<svg x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
          "viewBox=\"{} {} {} {}\">\n<path d=\"M{} {}h{}\" stroke=\"#888888\" "
          "stroke-width=\"{:.2f}\"/>\n{}</svg>\n",
          sheet_label_width + static_cast<double>(j) * (sheet_cell + sheet_gap), y, sheet_cell,
          height, box.x, box.y, box.width, box.height, box.x, ground, box.width,
          box.width / sheet_cell, io::layers_svg(row.frames[j], false, decimals));
    }
    y += height + sheet_gap;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.2f} {1:.2f}\" "
      "width=\"{0:.2f}\" height=\"{1:.2f}\" font-family=\"sans-serif\" font-size=\"13\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{2}</svg>\n",
      sheet_label_width + static_cast<double>(most) * (sheet_cell + sheet_gap), y, svg);
}

}  // namespace wavecurve::verification
