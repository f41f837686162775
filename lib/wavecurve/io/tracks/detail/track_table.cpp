#include "wavecurve/io/tracks/detail/track_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/drawings/detail/svg/tidy_outline.hpp"
#include "wavecurve/io/files/detail/table_rows.hpp"
#include "wavecurve/io/files/detail/text.hpp"
#include "wavecurve/io/tracks/detail/wide_table.hpp"

namespace wavecurve::io {

namespace {

constexpr std::size_t absent = std::string_view::npos, most_limbs = 100;

template <class... Values>
[[noreturn]] void refuse_table(fmt::format_string<Values...> form, Values&&... values) {
  throw std::invalid_argument(fmt::format(form, std::forward<Values>(values)...));
}

/// Where the columns are.
struct Columns {
  explicit Columns(const TableRow& header) : count(header.cells.size()) {
    std::vector<std::string> names;
    for (const std::string& cell : header.cells) names.push_back(column_name(cell));
    const auto find = [&](std::initializer_list<std::string_view> wanted) {
      for (const std::string_view name : wanted) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
      }
      return absent;
    };
    frame = find({"frame"}), limb = find({"limb", "contour"}), time = find({"t", "time"});
    k = find({"k"}), joint = find({"joint"});
    x = find({"x_treadmill", "x", "x_world"}), y = find({"y"});
    treadmill = find({"x_treadmill"}) != absent;
    const std::pair<std::size_t, std::string_view> needed[] = {
        {frame, "frame"}, {limb, "limb"}, {std::min(k, joint), "k or joint"}, {x, "x"}, {y, "y"}};
    for (const auto& [column, name] : needed) {
      if (column == absent)
        refuse_table("line {}: '{}' has no column {}", header.line, shown(header.text), name);
    }
  }

  std::size_t count, frame, limb, time, k, joint, x, y;
  bool treadmill;
};

struct Entry {
  std::string joint;
  double k = 0;
  Eigen::RowVector2d point;
  int line = 0;
};

struct Frame {
  std::optional<double> time;
  int line = 0;  ///< of its first entry
  std::map<std::string, std::vector<Entry>, std::less<>> limbs;
};

class TableReader {
 public:
  explicit TableReader(const std::vector<std::string>& wanted) : wanted_(wanted) {}

  void read_row(const TableRow& row) {
    if (!columns_) {
      columns_.emplace(row);
      return;
    }
    if (row.cells.size() != columns_->count) {
      refuse_table("line {}: '{}' has {} entries, the header has {}", row.line, shown(row.text),
                   row.cells.size(), columns_->count);
    }
    add(row);
  }

  TrackTable finish() {
    if (frames_.size() < 2) {
      refuse_table("{} frame{} of the limbs to be read; at least 2 are needed", frames_.size(),
                   frames_.size() == 1 ? "" : "s");
    }
    for (const std::string& limb : wanted_) {
      if (std::find(names_.begin(), names_.end(), limb) == names_.end()) {
        throw std::invalid_argument(unknown_name("limb", limb, names_));
      }
    }
    TrackTable table;
    table.tracks.times = times();
    table.joints = columns_->k == absent;
    table.treadmill = columns_->treadmill;
    for (const std::string& name : names_) table.tracks.limbs.push_back(limb(name));
    return table;
  }

 private:
  static double number_in(const TableRow& row, std::size_t column) {
    const auto value = cell_number(row.cells[column], row.separator);
    if (!value || std::abs(*value) > largest_coordinate) {
      refuse_table("line {}: '{}' is no number within +-{:g}", row.line, shown(row.cells[column]),
                   largest_coordinate);
    }
    return *value;
  }

  void add(const TableRow& row) {
    const int line = row.line;
    const std::string& name = row.cells[columns_->limb];
    if (name.empty()) refuse_table("line {}: the limb has no name", line);
    if (!wanted_.empty() && std::find(wanted_.begin(), wanted_.end(), name) == wanted_.end()) {
      return;
    }
    Frame& frame = frames_[number_in(row, columns_->frame)];
    if (frame.line == 0) frame.line = line;
    if (columns_->time != absent) {
      const double time = number_in(row, columns_->time);
      if (frame.time.value_or(time) != time) {
        refuse_table("line {}: time {} of frame {}, which is {} in line {}", line, time,
                     row.cells[columns_->frame], *frame.time, frame.line);
      }
      frame.time = time;
    }
    Entry entry;
    entry.line = line;
    if (columns_->k != absent) {
      entry.k = number_in(row, columns_->k);
    } else {
      entry.joint = row.cells[columns_->joint];
    }
    entry.point = {number_in(row, columns_->x), number_in(row, columns_->y)};
    note(name, line);
    frame.limbs[name].push_back(entry);
  }

  void note(const std::string& name, int line) {
    if (std::find(names_.begin(), names_.end(), name) != names_.end()) return;
    if (names_.size() == most_limbs) refuse_table("line {}: more than {} limbs", line, most_limbs);
    names_.push_back(name);
  }

  Eigen::VectorXd times() const {
    Eigen::VectorXd times(static_cast<Eigen::Index>(frames_.size()));
    Eigen::Index i = 0;
    for (const auto& [number, frame] : frames_) {
      times[i] = frame.time.value_or(number);
      if (i > 0 && !(times[i] > times[i - 1])) {
        refuse_table("line {}: time {} of frame {} does not exceed {}, that of the frame before",
                     frame.line, times[i], number, times[i - 1]);
      }
      ++i;
    }
    if (columns_->time == absent) check_spacing(times);
    return times;
  }

  static void check_spacing(const Eigen::VectorXd& numbers) {
    const Eigen::Index last = numbers.size() - 1;
    const Eigen::VectorXd steps = numbers.tail(last) - numbers.head(last);
    const double step = steps.minCoeff();
    for (Eigen::Index i = 0; i < last; ++i) {
      // Half a step: rounding is far below it, a missing frame above.
      if (steps[i] > 1.5 * step) {
        refuse_table("frame {} is missing: after {} comes {}; uneven frames need a column t",
                     numbers[i] + step, numbers[i], numbers[i + 1]);
      }
    }
  }

  gait::LimbTrack limb(std::string_view name) {
    gait::LimbTrack track{std::string(name), {}};
    const std::vector<Entry>* first = nullptr;
    for (auto& [number, frame] : frames_) {
      const auto found = frame.limbs.find(name);
      if (found == frame.limbs.end()) {
        refuse_table("limb {} is not in frame {}, but in others; it must be in all", name, number);
      }
      std::vector<Entry>& entries = found->second;
      if (!first) first = &entries;
      if (columns_->k != absent) {
        sort_points(entries, name, number);
      } else {
        sort_joints(entries, *first, name, number);
      }
      Contour points(static_cast<Eigen::Index>(entries.size()), 2);
      for (std::size_t i = 0; i < entries.size(); ++i) {
        points.row(static_cast<Eigen::Index>(i)) = entries[i].point;
      }
      track.outlines.push_back(std::move(points));
    }
    return track;
  }

  static void sort_points(std::vector<Entry>& entries, std::string_view limb, double frame) {
    const auto before = [](const Entry& a, const Entry& b) { return a.k < b.k; };
    std::stable_sort(entries.begin(), entries.end(), before);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (entries[i].k != static_cast<double>(i)) {
        refuse_table(
            "line {}: k is {} in limb {}, frame {}, but must be {}: 0, 1, 2, ... once each",
            entries[i].line, entries[i].k, limb, frame, i);
      }
    }
    if (entries.size() < 4) {
      refuse_table("line {}: limb {} has {} points in frame {}; at least 4 are needed",
                   entries.front().line, limb, entries.size(), frame);
    }
  }

  /// In the order of the first frame.
  static void sort_joints(std::vector<Entry>& entries, const std::vector<Entry>& first,
                          std::string_view limb, double frame) {
    if (entries.size() < 2) {
      refuse_table("line {}: limb {} has 1 joint; at least 2 are needed", entries.front().line,
                   limb);
    }
    if (entries.size() != first.size()) {
      refuse_table("line {}: limb {} has {} joints in frame {}, but {} in the first frame",
                   entries.front().line, limb, entries.size(), frame, first.size());
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
      const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(i);
      const auto found = std::find_if(
          begin, entries.end(), [&](const Entry& entry) { return entry.joint == first[i].joint; });
      if (found == entries.end()) {
        refuse_table("line {}: joint {} of limb {} is not once in frame {}, as in the first frame",
                     entries.front().line, first[i].joint, limb, frame);
      }
      std::iter_swap(begin, found);
    }
  }

  const std::vector<std::string>& wanted_;
  std::optional<Columns> columns_;
  std::map<double, Frame> frames_;
  std::vector<std::string> names_;  ///< in the order of the file
};

}  // namespace

TrackTable read_track_table(std::string_view text, const std::vector<std::string>& limbs,
                            double least_likelihood) {
  TableReader table(limbs);
  WideTable wide(limbs, least_likelihood);
  std::optional<bool> is_wide;
  for_each_row(text, [&](const TableRow& row) {
    if (!is_wide) is_wide = WideTable::is_header(row.cells);
    *is_wide ? wide.read_row(row) : table.read_row(row);
  });
  return is_wide.value_or(false) ? wide.finish() : table.finish();
}

}  // namespace wavecurve::io
