#include "wavecurve/io/drawings/detail/read_points.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "wavecurve/io/drawings/detail/svg/fit_view_box.hpp"
#include "wavecurve/io/drawings/detail/svg/path_builder.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_length.hpp"
#include "wavecurve/io/drawings/detail/svg/tidy_outline.hpp"
#include "wavecurve/io/files/detail/for_each_line.hpp"
#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

class PointsReader {
 public:
  void read_line(std::string_view line, int number) {
    const auto entries = split(line, ",;\t ");
    if (columns_ == 0 && is_header(entries)) return;
    if (columns_ == 0) columns_ = entries.size();
    if (entries.size() != columns_ || columns_ < 2 || columns_ > 3) {
      refuse(number, line, "is not x,y or contour,x,y");
    }
    add(columns_ == 3 ? entries.front() : std::string_view(),
        {coordinate(entries[columns_ - 2], number), coordinate(entries[columns_ - 1], number)});
  }

  DrawingFile finish() {
    path_.close();
    Layer layer{"contour", path_.take(), {}};
    layer.paint.fill = Colour{};
    layer.paint.fill_rule = FillRule::evenodd;
    transform_outline(layer.subpaths, Eigen::Affine2d::Identity());
    DrawingFile file;
    std::erase_if(layer.subpaths, has_no_length);
    if (layer.subpaths.empty()) {
      throw std::invalid_argument(contours_ == 0 ? "no points"
                                                 : "the points have no length: all are one");
    }
    if (layer.subpaths.size() < contours_) {
      file.warnings.push_back(fmt::format("{} contours of {} have no length",
                                          contours_ - layer.subpaths.size(), contours_));
    }
    file.drawing.layers.push_back(std::move(layer));
    file.drawing.view_box = fit_view_box(file.drawing);
    return file;
  }

 private:
  /// A first line without any number.
  bool is_header(const std::vector<std::string_view>& entries) {
    if (header_) return false;
    header_ = std::none_of(entries.begin(), entries.end(),
                           [](std::string_view entry) { return parse_number(entry).has_value(); });
    return header_;
  }

  [[noreturn]] static void refuse(int line, std::string_view value, std::string_view defect) {
    throw std::invalid_argument(fmt::format("line {}: '{}' {}", line, shown(value), defect));
  }

  static double coordinate(std::string_view text, int line) {
    const auto value = parse_number(text);
    if (!value || std::abs(*value) > largest_coordinate) {
      refuse(line, text, fmt::format("is no number within +-{:g}", largest_coordinate));
    }
    return *value;
  }

  void add(std::string_view contour, const Eigen::Vector2d& point) {
    if (contours_ > 0 && contour == contour_) return path_.line_to(point);
    path_.close();
    path_.move_to(point);
    contour_ = contour;
    ++contours_;
  }

  PathBuilder path_;
  std::string contour_;
  std::size_t columns_ = 0, contours_ = 0;
  bool header_ = false;
};

}  // namespace

DrawingFile read_points(std::string_view text) {
  PointsReader reader;
  for_each_line(text, [&](std::string_view line, int number) { reader.read_line(line, number); });
  return reader.finish();
}

}  // namespace wavecurve::io
