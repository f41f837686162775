#include "wavecurve/io/drawings/detail/stroke_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <utility>

#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"

namespace wavecurve::io {

namespace {

Contour disc(double x, double y, double radius) {
  // The chord of a side stays within a twentieth of a pixel of the circle.
  const double half_side = arccosine(1 - std::min(0.05 / radius, 0.5));
  const auto sides =
      static_cast<Eigen::Index>(std::max(8.0, std::ceil(std::numbers::pi / half_side)));
  Contour polygon(sides, 2);
  for (Eigen::Index i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
    polygon.row(i) << x + radius * cosine(angle), y + radius * sine(angle);
  }
  return polygon;
}

/// A contour without steps of no length.
Contour without_repetitions(const Contour& contour, bool open) {
  Contour result(contour.rows(), 2);
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < contour.rows(); ++i) {
    if (count == 0 || contour.row(i) != result.row(count - 1)) result.row(count++) = contour.row(i);
  }
  while (!open && count > 1 && result.row(count - 1) == result.row(0)) --count;
  return result.topRows(count);
}

/// A step along a line, and what lies at its left hand, a radius off.
struct Step {
  Step(const Eigen::RowVector2d& from, const Eigen::RowVector2d& to, double radius)
      : way(to - from), offset(radius / way.norm() * Eigen::RowVector2d(way.y(), -way.x())) {}
  Eigen::RowVector2d way, offset;
};

/// All pieces turn the same way, so that they add up under the nonzero rule.
Contour piece(std::initializer_list<Eigen::RowVector2d> points) {
  Contour polygon(static_cast<Eigen::Index>(points.size()), 2);
  Eigen::Index row = 0;
  for (const Eigen::RowVector2d& point : points) polygon.row(row++) = point;
  return polygon;
}

constexpr double least_seen = 0.02;  ///< of what is added to a stroke, in pixels

/// What lies between the rectangles of two steps, on the outer side of the turn.
void append_join(std::vector<Contour>& pieces, const Eigen::RowVector2d& here, const Step& before,
                 const Step& after, const Pen& pen) {
  const double cross = before.way.x() * after.way.y() - before.way.y() * after.way.x();
  const double dot = before.way.dot(after.way);
  const Eigen::RowVector2d from = cross > 0 ? before.offset : -after.offset;
  const Eigen::RowVector2d to = cross > 0 ? after.offset : -before.offset;
  // The square of the length of the miter in widths of the stroke, with the half angle's formula.
  const double ratio = 2 / (1 + dot / (before.way.norm() * after.way.norm()));
  if (pen.join == LineJoin::miter && ratio <= pen.miter_limit * pen.miter_limit &&
      pen.radius * (std::sqrt(ratio) - 1) > least_seen) {
    return pieces.push_back(piece({here, here + from, here + ratio / 2 * (from + to), here + to}));
  }
  pieces.push_back(piece({here, here + from, here + to}));
  if (pen.join != LineJoin::round) return;
  // What a chord leaves of the round join.
  const double turn = arctangent(cross, dot);
  if (pen.radius * turn * turn / 8 > least_seen) {
    pieces.push_back(disc(here.x(), here.y(), pen.radius));
  }
}

/// The end of an open line, which goes on along a step from here.
void append_cap(std::vector<Contour>& pieces, const Eigen::RowVector2d& here, const Step& step,
                const Pen& pen) {
  if (pen.cap == LineCap::round) pieces.push_back(disc(here.x(), here.y(), pen.radius));
  if (pen.cap != LineCap::square) return;
  const Eigen::RowVector2d back = -pen.radius / step.way.norm() * step.way;
  pieces.push_back(piece({here + step.offset, here - step.offset, here - step.offset + back,
                          here + step.offset + back}));
}

/// A line of no length: its caps alone, the square one along the axes.
void append_dot(std::vector<Contour>& pieces, const Eigen::RowVector2d& here, const Pen& pen) {
  if (pen.cap == LineCap::butt) return;
  const double r = pen.radius;
  if (pen.cap == LineCap::round) return pieces.push_back(disc(here.x(), here.y(), r));
  pieces.push_back(piece({here + Eigen::RowVector2d(-r, -r), here + Eigen::RowVector2d(r, -r),
                          here + Eigen::RowVector2d(r, r), here + Eigen::RowVector2d(-r, r)}));
}

/// What lies beside a vertex at the left hand, where the sides of two steps meet: none where so much of a
/// gap would show there, or a spike, or where the inner sides are too short to meet.
std::optional<Eigen::RowVector2d> shared_offset(const Step& before, const Step& after,
                                                double radius) {
  const double lengths = before.way.norm() * after.way.norm();
  const double cosine = before.way.dot(after.way) / lengths;
  if (!(cosine > 0)) return std::nullopt;
  const double half_tangent = std::sqrt((1 - std::min(cosine, 1.0)) / (1 + cosine));
  const double spike = radius * (std::sqrt(1 + half_tangent * half_tangent) - 1);
  const double shorter = std::min(before.way.norm(), after.way.norm());
  if (spike > least_seen || radius * half_tangent > shorter / 2) return std::nullopt;
  return (before.offset + after.offset) / (1 + cosine);
}

/// The rectangles of steps whose sides meet, as one polygon: along the left sides there, and along the
/// right sides back. It winds about a point as often as these pieces do together.
class Strip {
 public:
  void add(const Eigen::RowVector2d& point, const Eigen::RowVector2d& offset) {
    left_.push_back(point + offset);
    right_.push_back(point - offset);
  }
  void end(std::vector<Contour>& pieces) {
    const auto count = static_cast<Eigen::Index>(left_.size());
    Contour polygon(2 * count, 2);
    for (Eigen::Index i = 0; i < count; ++i) {
      polygon.row(i) = left_[static_cast<std::size_t>(i)];
      polygon.row(2 * count - 1 - i) = right_[static_cast<std::size_t>(i)];
    }
    pieces.push_back(std::move(polygon));
    left_.clear();
    right_.clear();
  }

 private:
  std::vector<Eigen::RowVector2d> left_, right_;
};

void append_stroke(std::vector<Contour>& pieces, const Contour& line, bool open, const Pen& pen) {
  const Eigen::Index n = line.rows(), edges = open ? n - 1 : n;
  if (n == 1) return append_dot(pieces, line.row(0), pen);
  const auto step = [&](Eigen::Index i) {
    return Step(line.row(i), line.row((i + 1) % n), pen.radius);
  };
  Step before = step(open ? 0 : n - 1);
  Strip strip;
  std::optional<Eigen::RowVector2d> at_start;
  for (Eigen::Index i = 0; i < edges; ++i) {
    const Eigen::RowVector2d here = line.row(i);
    const Step now = step(i);
    const bool is_end = open && i == 0;
    const auto shared = is_end ? std::nullopt : shared_offset(before, now, pen.radius);
    if (!shared && !is_end) {
      if (i > 0) {
        strip.add(here, before.offset);
        strip.end(pieces);
      }
      append_join(pieces, here, before, now, pen);
    }
    strip.add(here, shared.value_or(now.offset));
    if (i == 0) at_start = shared;
    before = now;
  }
  strip.add(line.row(edges % n), at_start.value_or(before.offset));
  strip.end(pieces);
  if (!open) return;
  append_cap(pieces, line.row(0), step(0), pen);
  append_cap(pieces, line.row(n - 1), Step(line.row(n - 1), line.row(n - 2), pen.radius), pen);
}

}  // namespace

std::vector<Contour> stroke_polygons(const std::vector<Contour>& lines,
                                     const std::vector<bool>& open, const Pen& pen) {
  std::vector<Contour> pieces;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool is_open = i < open.size() && open[i];
    append_stroke(pieces, without_repetitions(lines[i], is_open), is_open, pen);
  }
  return pieces;
}

}  // namespace wavecurve::io
