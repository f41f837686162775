#include "wavecurve/io/read_points.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "wavecurve/io/svg/path_builder.hpp"
#include "wavecurve/io/svg/svg_length.hpp"
#include "wavecurve/io/svg/text.hpp"
#include "wavecurve/io/svg/tidy_outline.hpp"

namespace wavecurve::io {

namespace {

class PointsReader {
 public:
  void read_line(std::string_view line, int number) {
    line = trimmed(line.substr(0, std::min(line.find('#'), line.size())));
    if (line.empty()) return;
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
    const std::size_t contours = layer.subpaths.size() + single_points_;
    std::erase_if(layer.subpaths, has_no_length);
    if (layer.subpaths.empty()) {
      throw std::invalid_argument(contours == 0 ? "no points"
                                                : "the points have no length: all are one");
    }
    if (layer.subpaths.size() < contours) {
      file.warnings.push_back(fmt::format("{} contours of {} have no length",
                                          contours - layer.subpaths.size(), contours));
    }
    file.drawing.view_box = box_of(layer.subpaths);
    file.drawing.layers.push_back(std::move(layer));
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
    if (points_ > 0 && contour == contour_) {
      path_.line_to(point);
      ++points_;
      return;
    }
    path_.close();
    path_.move_to(point);
    contour_ = contour;
    points_ = 1;
  }

  static ViewBox box_of(const std::vector<Subpath>& subpaths) {
    Eigen::AlignedBox2d box;
    for (const Subpath& subpath : subpaths) {
      for (const BezierSegment& segment : subpath.segments) {
        box.extend(segment.control.col(0));
        box.extend(segment.control.col(1));
      }
    }
    return {box.min().x(), box.min().y(), box.sizes().x(), box.sizes().y()};
  }

  PathBuilder path_;
  std::string contour_;
  std::size_t columns_ = 0, points_ = 0, single_points_ = 0;
  bool header_ = false;
};

}  // namespace

DrawingFile read_points(std::string_view text) {
  PointsReader reader;
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.read_line(text.substr(0, end), number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return reader.finish();
}

}  // namespace wavecurve::io
