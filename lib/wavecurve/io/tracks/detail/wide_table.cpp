#include "wavecurve/io/tracks/detail/wide_table.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/drawings/detail/svg/tidy_outline.hpp"
#include "wavecurve/io/files/detail/text.hpp"
#include "wavecurve/io/tracks/detail/joint_name.hpp"

namespace wavecurve::io {

namespace {

constexpr std::size_t most_joints = 1000, most_joint_points = 10'000'000;

template <class... Values>
[[noreturn]] void refuse_wide(fmt::format_string<Values...> form, Values&&... values) {
  throw std::invalid_argument(fmt::format(form, std::forward<Values>(values)...));
}

/// What a column holds of a joint: x, y, likelihood, or nothing that is known.
std::string kind_of(std::string_view word) {
  if (word == "x" || word == "y") return std::string(word);
  const bool likely =
      word == "likelihood" || word == "confidence" || word == "prob" || word == "probability";
  return likely ? "likelihood" : "";
}

struct ColumnOfJoint {
  std::string joint, kind;
};

/// A name that ends in one of the kinds: LF_toe_x, LF toe (x), LF.toe.likelihood, with a unit or without.
std::optional<ColumnOfJoint> column_of_joint(std::string_view cell) {
  auto words = column_words(cell);
  if (words.size() < 2) return std::nullopt;
  const std::string kind = kind_of(lower_case(words.back()));
  if (kind.empty()) return std::nullopt;
  words.pop_back();
  return ColumnOfJoint{fmt::format("{}", fmt::join(words, "_")), kind};
}

bool is_missing(std::string_view cell) {
  const std::string text = lower_case(trimmed(cell));
  return text.empty() || text == "nan" || text == "na";
}

double number_in(std::string_view cell, const TableRow& row) {
  const auto value = cell_number(cell, row.separator);
  if (!value || std::abs(*value) > largest_coordinate) {
    refuse_wide("line {}: '{}' is no number within +-{:g}", row.line, shown(cell),
                largest_coordinate);
  }
  return *value;
}

const Eigen::RowVector2d nowhere =
    Eigen::RowVector2d::Constant(std::numeric_limits<double>::quiet_NaN());

bool is_there(const Eigen::RowVector2d& point) { return point.allFinite(); }

}  // namespace

bool WideTable::is_header(const std::vector<std::string>& cells) {
  if (lower_case(cells[0]) == "scorer") return true;
  bool x = false, y = false;
  for (const std::string& cell : cells) {
    const std::string name = column_name(cell);
    if (name == "limb" || name == "contour" || name == "joint" || name == "k") return false;
    const auto column = column_of_joint(cell);
    x = x || (column && column->kind == "x");
    y = y || (column && column->kind == "y");
  }
  return x && y;
}

void WideTable::add_column(std::string_view joint, std::string_view kind, std::size_t column) {
  if (kind.empty()) return;
  auto found = std::find_if(joints_.begin(), joints_.end(),
                            [&](const Joint& one) { return one.name == joint; });
  if (found == joints_.end()) {
    if (joints_.size() == most_joints) refuse_wide("more than {} joints", most_joints);
    found = joints_.insert(joints_.end(), Joint{std::string(joint), {}, {}, {}, {}});
  }
  auto& place = kind == "x" ? found->x : kind == "y" ? found->y : found->likelihood;
  if (place) refuse_wide("two columns are {} of '{}'", kind, shown(joint));
  place = column;
}

void WideTable::read_header(const TableRow& row) {
  if (header_.empty() && lower_case(row.cells[0]) != "scorer") {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string name = column_name(row.cells[i]);
      if (const auto column = column_of_joint(row.cells[i])) {
        add_column(column->joint, column->kind, i);
      } else if (name == "t" || name == "time" || name == "timestamp") {
        time_ = i;
      } else if (name == "track" || name == "individual" || name == "animal") {
        track_ = i;
      } else if (!frame_ && (name == "frame" || name == "frame_idx" || name == "frame_index" ||
                             name == "index" || (i == 0 && name.empty()))) {
        frame_ = i;
      }
    }
    width_ = row.cells.size();
    return end_header(row.line);
  }
  if (!header_.empty() && row.cells.size() != header_[0].size()) {
    refuse_wide("line {}: '{}' has {} entries, the line before {}", row.line, shown(row.text),
                row.cells.size(), header_[0].size());
  }
  header_.push_back(row.cells);
  const auto row_called = [&](std::string_view name) {
    return std::find_if(header_.begin(), header_.end(),
                        [&](const auto& cells) { return lower_case(cells[0]) == name; });
  };
  const auto coords = row_called("coords"), bodyparts = row_called("bodyparts"),
             individuals = row_called("individuals");
  if (coords == header_.end()) {
    if (header_.size() == 4) refuse_wide("line {}: a header of scorer without coords", row.line);
    return;
  }
  if (bodyparts == header_.end()) {
    refuse_wide("line {}: a header of scorer without bodyparts", row.line);
  }
  for (std::size_t i = 1; i < row.cells.size(); ++i) {
    if (individuals != header_.end() && (*individuals)[i] != (*individuals)[1]) {
      refuse_wide("the table holds several animals, '{}' and '{}'; one is read",
                  shown((*individuals)[1]), shown((*individuals)[i]));
    }
    add_column((*bodyparts)[i], kind_of(lower_case((*coords)[i])), i);
  }
  frame_ = 0;
  width_ = row.cells.size();
  end_header(row.line);
}

void WideTable::end_header(int line) {
  for (const Joint& joint : joints_) {
    if (joint.x && joint.y) continue;
    refuse_wide("line {}: '{}' has no column {}", line, shown(joint.name), joint.x ? "y" : "x");
  }
}

/// SLEAP has a line for each animal in a frame.
void WideTable::check_animal(const TableRow& row) {
  if (!track_) return;
  const std::string& animal = row.cells[*track_];
  if (frames_.empty()) animal_ = animal;
  if (animal == animal_) return;
  refuse_wide("line {}: the table holds several animals, '{}' and '{}'; one is read", row.line,
              shown(animal_), shown(animal));
}

void WideTable::read_row(const TableRow& row) {
  if (width_ == 0) return read_header(row);
  if (row.cells.size() != width_) {
    refuse_wide("line {}: '{}' has {} entries, the header has {}", row.line, shown(row.text),
                row.cells.size(), width_);
  }
  if ((frames_.size() + 1) * joints_.size() > most_joint_points) {
    refuse_wide("line {}: more than {} points", row.line, most_joint_points);
  }
  check_animal(row);
  const double frame =
      frame_ ? number_in(row.cells[*frame_], row) : static_cast<double>(frames_.size());
  if (!frames_.empty() && !(frame > frames_.back())) {
    refuse_wide("line {}: frame {} does not exceed {}, that of the line before", row.line, frame,
                frames_.back());
  }
  frames_.push_back(frame);
  if (time_) row_times_.push_back(number_in(row.cells[*time_], row));
  for (Joint& joint : joints_) {
    const std::string &x = row.cells[*joint.x], &y = row.cells[*joint.y];
    const bool missing = is_missing(x) || is_missing(y);
    Eigen::RowVector2d point = nowhere;
    if (!missing) point = {number_in(x, row), number_in(y, row)};
    if (!missing && joint.likelihood) {
      const std::string& likelihood = row.cells[*joint.likelihood];
      if (is_missing(likelihood) || number_in(likelihood, row) < least_likelihood_) point = nowhere;
    }
    joint.points.push_back(point);
  }
}

std::vector<WideTable::Limb> WideTable::limbs() {
  std::vector<Limb> limbs;
  std::vector<std::string> alone;
  for (Joint& joint : joints_) {
    const std::string name = limb_of_joint(joint.name);
    auto found = std::find_if(limbs.begin(), limbs.end(),
                              [&](const Limb& limb) { return limb.name == name; });
    if (name.empty()) {
      alone.push_back(joint.name);
      continue;
    }
    if (found == limbs.end()) found = limbs.insert(limbs.end(), Limb{name, {}});
    found->joints.push_back(&joint);
  }
  std::erase_if(limbs, [&](Limb& limb) {
    // Joints that were not found are left out, unless they are those of a leg.
    if (limb.name.size() != 2) {
      std::erase_if(limb.joints, [&](const Joint* joint) {
        const bool found = std::count_if(joint->points.begin(), joint->points.end(), is_there) > 1;
        if (!found) alone.push_back(joint->name);
        return !found;
      });
    }
    if (limb.joints.size() > 1) return false;
    if (limb.joints.empty()) return true;
    alone.push_back(limb.joints[0]->name);
    return true;
  });
  std::vector<std::string> names;
  for (Limb& limb : limbs) {
    names.push_back(limb.name);
    const auto rank = [](const Joint* joint) { return rank_of_joint(joint->name); };
    const bool known = std::all_of(limb.joints.begin(), limb.joints.end(),
                                   [&](const Joint* joint) { return rank(joint).has_value(); });
    if (!known) continue;
    std::stable_sort(limb.joints.begin(), limb.joints.end(),
                     [&](const Joint* a, const Joint* b) { return *rank(a) < *rank(b); });
  }
  for (const std::string& limb : wanted_) {
    if (std::find(names.begin(), names.end(), limb) != names.end()) continue;
    throw std::invalid_argument(unknown_name("limb", limb, names));
  }
  if (!wanted_.empty()) {
    std::erase_if(limbs, [&](const Limb& limb) {
      return std::find(wanted_.begin(), wanted_.end(), limb.name) == wanted_.end();
    });
  } else if (!alone.empty()) {
    warnings_.push_back(fmt::format("not read, for no limb has two such joints: {}",
                                    shown(fmt::format("{}", fmt::join(alone, ", ")))));
  }
  if (limbs.empty()) {
    refuse_wide(
        "no limb has two joints: joints are called LF_hip, LF_toe, ..., or front_left_paw, ...");
  }
  return limbs;
}

/// Frames that the table leaves out, as SLEAP does where it finds no animal, are missing points.
void WideTable::fill_frames() {
  if (time_ || frames_.size() < 2) return;
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < frames_.size(); ++i)
    step = std::min(step, frames_[i] - frames_[i - 1]);
  const double count = std::round((frames_.back() - frames_[0]) / step) + 1;
  if (!(count <= 2.0 * static_cast<double>(frames_.size()))) {
    refuse_wide("frames are missing: there are {} from {} to {}, in steps of {}", frames_.size(),
                frames_[0], frames_.back(), step);
  }
  std::vector<double> all;
  std::vector<std::size_t> places;  // of the rows
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const double before = i > 0 ? frames_[i - 1] : frames_[i];
    const double absent = std::round((frames_[i] - before) / step) - 1;
    for (int k = 1; k <= absent; ++k) all.push_back(before + k * step);
    places.push_back(all.size());
    all.push_back(frames_[i]);
  }
  absent_frames_ = all.size() - frames_.size();
  if (absent_frames_ == 0) return;
  for (Joint& joint : joints_) {
    std::vector<Eigen::RowVector2d> points(all.size(), nowhere);
    for (std::size_t i = 0; i < places.size(); ++i) points[places[i]] = joint.points[i];
    joint.points = std::move(points);
  }
  frames_ = std::move(all);
}

/// Fills the missing points in: linearly in time between those that are there, as the nearest beyond them.
void WideTable::interpolate(Joint& joint) {
  auto& points = joint.points;
  const auto there = std::count_if(points.begin(), points.end(), is_there);
  const auto all = static_cast<std::ptrdiff_t>(points.size());
  if (there == all) return;
  const std::string below =
      joint.likelihood ? fmt::format(", or of a likelihood below {}", least_likelihood_) : "";
  if (there < 2) {
    refuse_wide("'{}': {} of {} points are missing{}", shown(joint.name), all - there, all, below);
  }
  std::size_t longest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_there(points[i])) continue;
    std::size_t end = i;
    while (end < points.size() && !is_there(points[end])) ++end;
    longest = std::max(longest, end - i);
    for (std::size_t k = i; k < end; ++k) {
      if (i == 0) {
        points[k] = points[end];
      } else if (end == points.size()) {
        points[k] = points[i - 1];
      } else {
        const auto& at = time_ ? row_times_ : frames_;
        const double share = (at[k] - at[i - 1]) / (at[end] - at[i - 1]);
        points[k] = (1 - share) * points[i - 1] + share * points[end];
      }
    }
    i = end - 1;
  }
  warnings_.push_back(
      fmt::format("'{}': {} of {} points are missing{}; they are interpolated, at most {} in a row",
                  shown(joint.name), all - there, all, below, longest));
}

Eigen::VectorXd WideTable::times() const {
  const auto& values = time_ ? row_times_ : frames_;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] > values[i - 1]) continue;
    refuse_wide("time {} does not exceed {}, that of the frame before", values[i], values[i - 1]);
  }
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

TrackTable WideTable::finish() {
  if (frames_.size() < 2) {
    refuse_wide("{} frame{}; at least 2 are needed", frames_.size(),
                frames_.size() == 1 ? "" : "s");
  }
  fill_frames();
  TrackTable table;
  table.joints = true;
  table.tracks.times = times();
  if (absent_frames_ > 0) {
    warnings_.push_back(fmt::format("{} frames of {} are not in the table; they are interpolated",
                                    absent_frames_, frames_.size()));
  }
  for (const Limb& limb : limbs()) {
    gait::LimbTrack track{limb.name, {}};
    for (Joint* joint : limb.joints) interpolate(*joint);
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      Contour points(static_cast<Eigen::Index>(limb.joints.size()), 2);
      for (std::size_t k = 0; k < limb.joints.size(); ++k) {
        points.row(static_cast<Eigen::Index>(k)) = limb.joints[k]->points[i];
      }
      track.outlines.push_back(std::move(points));
    }
    table.tracks.limbs.push_back(std::move(track));
  }
  table.warnings = std::move(warnings_);
  return table;
}

}  // namespace wavecurve::io
