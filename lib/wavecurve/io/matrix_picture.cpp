#include "wavecurve/io/matrix_picture.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "wavecurve/elementary/logarithm.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/io/drawings/detail/svg_paint.hpp"
#include "wavecurve/io/files/detail/xml_escaped.hpp"

namespace wavecurve::io {

namespace {

constexpr Eigen::Index largest_grid = 256;
constexpr int shades = 48;
constexpr int decades_shown = 12;
constexpr double picture_side = 512;  ///< of the longer edge of the matrix, in user units
constexpr double left = 72, top = 64, bar_width = 18;

/// Shade 1 .. shades, light to dark: a cubehelix (D. A. Green, 2011), whose luminance is linear by
/// construction.
std::string entry_colour(int shade) {
  const double light = 0.93 - 0.88 * (shade - 1) / (shades - 1);
  const double angle = 2 * std::numbers::pi * (0.5 / 3 + 1 - 0.9 * light);
  const double amplitude = 1.1 * light * (1 - light) / 2;
  const double c = cosine(angle), s = sine(angle);
  const auto channel = [&](double a, double b) { return light + amplitude * (a * c + b * s); };
  return hex_colour({channel(-0.14861, 1.78277), channel(-0.29227, -0.90649), channel(1.97294, 0)});
}

/// The powers of ten between which the colours run.
struct Scale {
  double lowest = 0, highest = 1;

  int shade(double magnitude) const {
    const double position = (logarithm_10(magnitude) - lowest) / (highest - lowest);
    return 1 + static_cast<int>(std::lround(std::clamp(position, 0.0, 1.0) * (shades - 1)));
  }
};

/// Largest magnitude in each cell.
Eigen::MatrixXd cells_of(const Eigen::SparseMatrix<double>& matrix, Eigen::Index cell) {
  Eigen::MatrixXd cells =
      Eigen::MatrixXd::Zero((matrix.rows() + cell - 1) / cell, (matrix.cols() + cell - 1) / cell);
  for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry) {
      double& largest = cells(entry.row() / cell, j / cell);
      largest = std::max(largest, std::abs(entry.value()));
    }
  }
  return cells;
}

Scale scale_of(const Eigen::MatrixXd& cells) {
  double smallest = 0, largest = 0;
  for (double magnitude : cells.reshaped()) {
    if (magnitude == 0) continue;
    smallest = smallest == 0 ? magnitude : std::min(smallest, magnitude);
    largest = std::max(largest, magnitude);
  }
  if (largest == 0) return {};
  Scale scale{std::floor(logarithm_10(smallest)), std::ceil(logarithm_10(largest))};
  scale.lowest = std::clamp(scale.lowest, scale.highest - decades_shown, scale.highest - 1);
  return scale;
}

/// One path a shade, of the horizontal runs of equal shade, in units of cells.
std::string draw_cells(const Eigen::MatrixXd& cells, const Scale& scale) {
  std::map<int, std::string> paths;
  for (Eigen::Index i = 0; i < cells.rows(); ++i) {
    for (Eigen::Index j = 0; j < cells.cols();) {
      const auto shade = [&](Eigen::Index column) {
        return cells(i, column) == 0 ? 0 : scale.shade(cells(i, column));
      };
      Eigen::Index end = j + 1;
      while (end < cells.cols() && shade(end) == shade(j)) ++end;
      const Eigen::Index run = end - j;
      if (shade(j) > 0)
        fmt::format_to(std::back_inserter(paths[shade(j)]), "M{} {}h{}v1h-{}z", j, i, run, run);
      j = end;
    }
  }
  std::string svg;
  for (const auto& [shade, path] : paths) {
    svg += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", entry_colour(shade), path);
  }
  return svg;
}

std::string draw_borders(const std::vector<Eigen::Index>& borders, double width, double height,
                         double unit) {
  std::string path;
  for (Eigen::Index border : borders) {
    const double at = unit * static_cast<double>(border);
    path += fmt::format("M{:.2f} 0V{:.2f}M0 {:.2f}H{:.2f}", at, height, at, width);
  }
  return fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"#d00000\" stroke-width=\"0.8\"/>\n"
      "<rect width=\"{:.2f}\" height=\"{:.2f}\" fill=\"none\" stroke=\"black\"/>\n",
      path, width, height);
}

std::string label(double x, double y, std::string_view anchor, std::string_view text,
                  std::string_view more = "") {
  return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, more, xml_escaped(text));
}

std::string draw_axes(const Eigen::SparseMatrix<double>& matrix, double unit) {
  const double width = unit * static_cast<double>(matrix.cols());
  const double height = unit * static_cast<double>(matrix.rows());
  std::string svg;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Eigen::Index row = matrix.rows() * quarter / 4, column = matrix.cols() * quarter / 4;
    const double x = unit * (static_cast<double>(column) + 0.5);
    const double y = unit * (static_cast<double>(row) + 0.5);
    svg += label(x, height + 18, "middle", std::to_string(column));
    svg += label(-8, y + 4, "end", std::to_string(row));
    svg +=
        fmt::format("<path d=\"M{:.2f} {:.2f}v5M0 {:.2f}h-5\" stroke=\"black\"/>\n", x, height, y);
  }
  svg += label(width / 2, height + 38, "middle", "column index");
  svg += label(0, 0, "middle", "row index",
               fmt::format(" transform=\"translate(-46 {:.2f}) rotate(-90)\"", height / 2));
  return svg;
}

std::string draw_colour_bar(const Scale& scale, std::string_view quantity, double height) {
  std::string svg;
  const double step = height / shades;
  for (int shade = 1; shade <= shades; ++shade) {
    svg += fmt::format("<rect y=\"{:.2f}\" width=\"{}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
                       height - step * shade, bar_width, step + (shade > 1 ? 0.3 : 0),
                       entry_colour(shade));
  }
  const int decades = static_cast<int>(scale.highest - scale.lowest);
  const int stride = (decades + 5) / 6;
  for (int i = 0; i <= decades; i += stride) {
    const double y = height - height * i / decades;
    svg += fmt::format("<path d=\"M{} {:.2f}h5\" stroke=\"black\"/>\n", bar_width, y);
    svg += label(bar_width + 8, y + 4, "start", fmt::format("1e{:.0f}", scale.lowest + i));
  }
  svg += fmt::format("<rect width=\"{}\" height=\"{:.2f}\" fill=\"none\" stroke=\"black\"/>\n",
                     bar_width, height);
  svg += label(
      0, 0, "middle", quantity,
      fmt::format(" transform=\"translate({} {:.2f}) rotate(-90)\"", bar_width + 64, height / 2));
  return svg;
}

}  // namespace

std::string matrix_picture(const Eigen::SparseMatrix<double>& matrix,
                           const std::vector<Eigen::Index>& borders,
                           const MatrixPictureText& text) {
  const Eigen::Index longer = std::max<Eigen::Index>({matrix.rows(), matrix.cols(), 1});
  const Eigen::Index cell = (longer + largest_grid - 1) / largest_grid;
  const Eigen::MatrixXd cells = cells_of(matrix, cell);
  const Scale scale = scale_of(cells);
  const double unit = picture_side / static_cast<double>(longer);
  const double width = unit * static_cast<double>(matrix.cols());
  const double height = unit * static_cast<double>(matrix.rows());

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"title desc\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n",
      left + width + 128, top + height + 52);
  svg += fmt::format("<title id=\"title\">{}</title>\n<desc id=\"desc\">{}</desc>\n",
                     xml_escaped(text.title), xml_escaped(text.description));
  svg += "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  svg += label(left, 36, "start", text.title, " font-size=\"16\"");
  svg += fmt::format("<g transform=\"translate({} {})\">\n", left, top);
  svg += fmt::format("<g transform=\"scale({:.6f})\" shape-rendering=\"crispEdges\">\n",
                     unit * static_cast<double>(cell));
  svg += draw_cells(cells, scale) + "</g>\n";
  svg += draw_borders(borders, width, height, unit) + draw_axes(matrix, unit);
  svg += fmt::format("<g transform=\"translate({:.2f} 0)\">\n", width + 24);
  svg += draw_colour_bar(scale, text.quantity, height) + "</g>\n</g>\n</svg>\n";
  return svg;
}

}  // namespace wavecurve::io
