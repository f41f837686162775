#include "wavecurve/io/drawings/detail/read_points.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>

#include <fmt/format.h>

#include "wavecurve/io/drawings/detail/point_columns.hpp"
#include "wavecurve/io/drawings/detail/svg/fit_view_box.hpp"
#include "wavecurve/io/drawings/detail/svg/path_builder.hpp"
#include "wavecurve/io/drawings/detail/svg/tidy_outline.hpp"
#include "wavecurve/io/files/detail/table_rows.hpp"
#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

constexpr std::size_t most_points = 4'000'000;

/// What makes an outline of its own, rather than a chance to read the table otherwise.
constexpr std::size_t fewest_points = 3;

/// A point, and what the table says of where it belongs.
struct TablePoint {
  Eigen::Vector2d at;
  int key = 0;    ///< which entry of the columns of contours, in order of appearance
  int run = 0;    ///< which run of the same entry of the column of the index
  int block = 0;  ///< how many gaps come before it
  double index = 0;
  int line = 0;
};

/// Whether runs of equal numbers, which count up, are contours: one of them has points enough.
bool are_contours(const std::vector<TablePoint>& points, int TablePoint::*number) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    length = i > 0 && points[i].*number == points[i - 1].*number ? length + 1 : 1;
    if (length == fewest_points) return true;
  }
  return false;
}

class PointsReader {
 public:
  explicit PointsReader(const PointOptions& options) : options_(options) {}

  void read_row(const TableRow& row) {
    if (width_ == 0 && header_.empty() && is_point_header(row.cells, row.separator)) {
      header_ = row.cells;
      return;
    }
    if (width_ == 0) find_columns(row);
    if (row.cells.size() != width_) {
      refuse(row.line, row.text,
             fmt::format("has {} {}, {} has {}", row.cells.size(),
                         row.cells.size() == 1 ? "entry" : "entries",
                         header_.empty() ? "the first line" : "the header", width_));
    }
    add(row);
  }

  DrawingFile finish() {
    if (points_.empty()) throw std::invalid_argument("no points");
    for (std::size_t i = 0; i < columns_.time.size(); ++i) {
      if (time_changes_[i]) refuse_record(columns_.time[i]);
    }
    if (is_guess_) decide_first_column();
    settle_keys();
    return drawing_of(contours());
  }

 private:
  [[noreturn]] static void refuse(int line, std::string_view value, std::string_view defect) {
    throw std::invalid_argument(fmt::format("line {}: '{}' {}", line, shown(value), defect));
  }
  template <typename... Values>
  void warn(fmt::format_string<Values...> form, Values&&... values) {
    file_.warnings.push_back(fmt::format(form, std::forward<Values>(values)...));
  }

  void find_columns(const TableRow& row) {
    width_ = row.cells.size();
    // A comment is a header if it names columns, as many as there are.
    if (header_.empty() && row.comment.size() == width_ && names_coordinates(row.comment)) {
      header_ = row.comment;
    }
    if (!header_.empty()) {
      // R leaves the name of the column of names away.
      if (header_.size() + 1 == width_) {
        warn("the header names {} columns of {}: the first is taken for the names of the lines",
             header_.size(), width_);
        header_.insert(header_.begin(), "");
      }
      width_ = header_.size();
      columns_ = point_columns(header_);
      for (std::string& warning : columns_.warnings) file_.warnings.push_back(std::move(warning));
      time_.resize(columns_.time.size());
      time_changes_.resize(columns_.time.size());
      return;
    }
    while (width_ > 2 && row.cells[width_ - 1].empty()) --width_;
    const bool comma_at_end = width_ < row.cells.size();
    if (width_ < 2 || width_ > 3) {
      refuse(row.line, row.text,
             fmt::format("has {} {}, and no header names x and y", width_,
                         width_ == 1 ? "entry" : "entries"));
    }
    is_guess_ = width_ == 3;
    if (is_guess_) columns_ = {1, 2, 0, {0}, {}, {}};
    if (comma_at_end) width_ = row.cells.size();
  }

  double coordinate(const TableRow& row, std::size_t column) const {
    const auto value = cell_number(row.cells[column], row.separator);
    if (!value || std::abs(*value) > largest_coordinate) {
      refuse(row.line, row.cells[column],
             fmt::format("is no number within +-{:g}", largest_coordinate));
    }
    return *value;
  }

  void add(const TableRow& row) {
    if (points_.size() == most_points) {
      refuse(row.line, row.text, fmt::format("is one of more than {} points", most_points));
    }
    if (row.after_gap) ++block_;
    TablePoint point;
    point.at = {coordinate(row, columns_.x), coordinate(row, columns_.y)};
    if (options_.y_up) point.at.y() *= -1;
    point.key = key_of(row);
    point.block = block_;
    point.line = row.line;
    if (columns_.index) {
      const std::string& entry = row.cells[*columns_.index];
      if (!points_.empty() && entry != last_index_) ++run_;
      last_index_ = entry;
      point.run = run_;
      point.index = cell_number(entry, row.separator).value_or(std::nan(""));
    }
    for (std::size_t i = 0; i < columns_.time.size(); ++i) {
      const std::string& time = row.cells[columns_.time[i]];
      if (points_.empty()) time_[i] = time;
      if (time != time_[i]) time_changes_[i] = true;
    }
    points_.push_back(point);
  }

  int key_of(const TableRow& row) {
    if (columns_.contour.empty()) return 0;
    std::string key;
    for (const std::size_t column : columns_.contour) key += row.cells[column] + '\n';
    return keys_.emplace(std::move(key), static_cast<int>(keys_.size())).first->second;
  }

  [[noreturn]] void refuse_record(std::size_t column) const {
    throw std::invalid_argument(fmt::format(
        "the column '{}' changes: the table is a record in time, but a drawing stands still; "
        "'wavecurve gait fit' reads records",
        shown(header_[column])));
  }

  /// In three columns without a header the first is the contour where it makes contours, or numbers the
  /// points; unless the last might as well be what makes contours.
  void decide_first_column() {
    const bool counts =
        std::all_of(points_.begin() + 1, points_.end(),
                    [&](const TablePoint& point) { return point.index == (&point)[-1].index + 1; });
    std::vector<TablePoint> by_last = points_;
    for (std::size_t i = 1; i < by_last.size(); ++i) {
      by_last[i].run = by_last[i - 1].run + (by_last[i].at.y() == by_last[i - 1].at.y() ? 0 : 1);
    }
    const bool named = std::isnan(points_[0].index);
    const bool groups = are_contours(points_, &TablePoint::run);
    const bool last_groups = are_contours(by_last, &TablePoint::run) &&
                             by_last.back().run * 3 < static_cast<int>(points_.size());
    if (points_.size() < fewest_points || named || (groups && !last_groups)) return;
    if (counts && !last_groups) {
      columns_.contour.clear();
      for (TablePoint& point : points_) point.key = 0;
      return;
    }
    throw std::invalid_argument(fmt::format(
        "line {}: three columns, and no header that says what they are, as contour,x,y does",
        points_[0].line));
  }

  /// What tells every point from every other one makes no contours.
  void settle_keys() {
    const bool all_differ = keys_.size() == points_.size() && points_.size() >= fewest_points;
    if (all_differ && !columns_.contour.empty()) {
      for (TablePoint& point : points_) point.key = 0;
      warn("the column '{}' differs in all lines: it is taken for the name of each point",
           is_guess_ ? "1" : shown(header_[columns_.contour[0]]));
    }
    if (!are_contours(points_, &TablePoint::block)) {
      for (TablePoint& point : points_) point.block = 0;
    }
    if (!columns_.index || is_guess_) return;
    if (are_contours(points_, &TablePoint::run)) return;
    split_at_restarts();
  }

  /// The numbers of points in one contour grow; where they begin anew, another contour does.
  void split_at_restarts() {
    int part = 0, first = 0;
    bool falls = false;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      TablePoint& point = points_[i];
      const bool same =
          i > 0 && point.key == points_[i - 1].key && point.block == points_[i - 1].block;
      if (!same) {
        first = static_cast<int>(i);
      } else if (point.index == points_[static_cast<std::size_t>(first)].index) {
        if (part++ == 0) {
          warn("line {}: the numbers in the column '{}' begin anew: taken for another contour",
               point.line, shown(header_[*columns_.index]));
        }
        first = static_cast<int>(i);
      } else if (!(point.index > points_[i - 1].index) && !falls && !std::isnan(point.index)) {
        falls = true;
        warn("line {}: points are taken in the order of the lines, not of the column '{}'",
             point.line, shown(header_[*columns_.index]));
      }
      point.run = part;
    }
  }

  using Points = std::vector<Eigen::Vector2d>;

  std::vector<Points> contours() {
    std::vector<Points> contours;
    std::map<std::tuple<int, int, int>, std::size_t> known;
    std::size_t last = 0;
    bool told = false;
    for (const TablePoint& point : points_) {
      const int run = is_guess_ ? 0 : point.run;
      const auto [found, is_new] =
          known.emplace(std::tuple(point.key, point.block, run), contours.size());
      if (is_new) contours.emplace_back();
      if (!is_new && found->second != last && !told) {
        told = true;
        warn("line {}: a contour goes on that another one has interrupted", point.line);
      }
      last = found->second;
      contours[last].push_back(point.at);
    }
    return contours;
  }

  DrawingFile drawing_of(const std::vector<Points>& contours) {
    const std::size_t fewest = options_.open ? 2 : fewest_points;
    PathBuilder path;
    std::size_t too_few = 0;
    for (const Points& points : contours) {
      if (points.size() < fewest) {
        ++too_few;
        continue;
      }
      path.move_to(points[0]);
      for (std::size_t i = 1; i < points.size(); ++i) path.line_to(points[i]);
      if (!options_.open) path.close();
    }
    Layer layer{"contour", path.take(), {}};
    transform_outline(layer.subpaths, Eigen::Affine2d::Identity());
    std::erase_if(layer.subpaths, has_no_length);
    if (layer.subpaths.empty()) {
      throw std::invalid_argument(
          too_few == contours.size()
              ? fmt::format("no contour has the {} points that it needs", fewest)
              : "the points have no length: all are one");
    }
    if (layer.subpaths.size() < contours.size()) {
      warn("{} contours of {} have fewer than {} points, or no length, and are skipped",
           contours.size() - layer.subpaths.size(), contours.size(), fewest);
    }
    set_paint(layer);
    file_.drawing.layers.push_back(std::move(layer));
    file_.drawing.view_box = fit_view_box(file_.drawing);
    return std::move(file_);
  }

  /// Closed contours are filled, open ones stroked, by a hundredth of the size.
  void set_paint(Layer& layer) const {
    if (!options_.open) {
      layer.paint.fill = Colour{};
      layer.paint.fill_rule = FillRule::evenodd;
      return;
    }
    Drawing alone;
    alone.layers = {layer};
    const ViewBox box = fit_view_box(alone);
    layer.paint.stroke = Colour{};
    layer.paint.stroke_width = std::max(box.width, box.height) / 100;
  }

  const PointOptions& options_;
  DrawingFile file_;
  std::vector<std::string> header_;
  std::size_t width_ = 0;  ///< the number of columns, once it is known
  PointColumns columns_;
  bool is_guess_ = false;  ///< three columns without a header
  std::vector<TablePoint> points_;
  std::map<std::string, int> keys_;
  std::string last_index_;
  std::vector<std::string> time_;  ///< the first entries of these columns
  std::vector<bool> time_changes_;
  int run_ = 0, block_ = 0;
};

}  // namespace

DrawingFile read_points(std::string_view text, const PointOptions& options) {
  PointsReader reader(options);
  for_each_row(text, [&](const TableRow& row) { reader.read_row(row); });
  return reader.finish();
}

}  // namespace wavecurve::io
