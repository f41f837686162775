#include "verification/stand_ins/frame_grid.hpp"

#include <fmt/format.h>

#include "wavecurve/io/animations/detail/control_points.hpp"

namespace wavecurve::verification {

namespace {

constexpr double grid_cell = 120, grid_gap = 8, grid_label_width = 150, grid_title_height = 28;

struct Bounds {
  Eigen::RowVector2d low, high;
};

Bounds bounds_of(const std::vector<FrameRow>& rows, const Contour& rest) {
  Bounds bounds{rest.colwise().minCoeff(), rest.colwise().maxCoeff()};
  for (const FrameRow& row : rows) {
    for (const Contour& frame : row.frames) {
      bounds.low = bounds.low.cwiseMin(frame.colwise().minCoeff());
      bounds.high = bounds.high.cwiseMax(frame.colwise().maxCoeff());
    }
  }
  return bounds;
}

}  // namespace

std::string frame_grid(const std::vector<FrameRow>& rows, const std::vector<std::string>& columns,
                       const Contour& rest) {
  const io::Decimals decimals(2);
  const Bounds bounds = bounds_of(rows, rest);
  const double scale = (grid_cell - grid_gap) / (bounds.high - bounds.low).maxCoeff();
  const Eigen::RowVector2d centre = (bounds.low + bounds.high) / 2;
  const double height = scale * (bounds.high - bounds.low)[1] + grid_gap;
  const auto path = [&](const Contour& contour) {
    Contour placed = scale * (contour.rowwise() - centre);
    placed.col(1) *= -1;
    return io::path_data({placed}, false, decimals);
  };
  const std::string rest_path = path(rest);
  std::string svg;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    svg += fmt::format("<text x=\"{:.2f}\" y=\"20\" text-anchor=\"middle\">{}</text>\n",
                       grid_label_width + (static_cast<double>(j) + 0.5) * grid_cell, columns[j]);
  }
  double y = grid_title_height + height / 2;
  for (const FrameRow& row : rows) {
    svg += fmt::format("<text x=\"{}\" y=\"{:.2f}\">{}</text>\n", grid_gap, y + 5, row.label);
    for (std::size_t j = 0; j < row.frames.size(); ++j) {
      svg += fmt::format(
          "<g transform=\"translate({:.2f} {:.2f})\"><path fill=\"none\" stroke=\"#bbbbbb\" "
          "stroke-width=\"3\" d=\"{}\"/>\n<path fill=\"none\" stroke=\"#1f5a96\" "
          "stroke-width=\"1.5\" stroke-linejoin=\"round\" d=\"{}\"/></g>\n",
          grid_label_width + (static_cast<double>(j) + 0.5) * grid_cell, y, rest_path,
          path(row.frames[j]));
    }
    y += height;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.2f} {1:.2f}\" "
      "width=\"{0:.2f}\" height=\"{1:.2f}\" font-family=\"sans-serif\" font-size=\"14\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{2}</svg>\n",
      grid_label_width + static_cast<double>(columns.size()) * grid_cell + grid_gap,
      y - height / 2 + grid_gap, svg);
}

}  // namespace wavecurve::verification
