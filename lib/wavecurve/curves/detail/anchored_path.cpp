#include "wavecurve/curves/detail/anchored_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "wavecurve/curves/detail/bezier.hpp"
#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;

constexpr double anchor_corner = std::numbers::pi / 9;  ///< as of Corners

bool has_length(const BezierSegment& segment) {
  return !(segment.control.colwise() - segment.control.col(0)).isZero(0);
}

std::vector<std::size_t> segments_with_length(const Subpath& subpath) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < subpath.segments.size(); ++i) {
    if (has_length(subpath.segments[i])) numbers.push_back(i);
  }
  check_at_least("the number of segments of a contour", numbers.size(), 1);
  return numbers;
}

/// The segments of those numbers, closed by a line; that has the number after the last.
Subpath closed_path(const Subpath& subpath, std::vector<std::size_t>& numbers) {
  Subpath closed{{}, true};
  for (const std::size_t number : numbers) closed.segments.push_back(subpath.segments[number]);
  const Eigen::Vector2d start = closed.segments.front().control.col(0);
  const Eigen::Vector2d end = closed.segments.back().control.rightCols(1);
  if (start == end) return closed;
  BezierSegment line;
  line.control.resize(2, 2);
  line.control << end, start;
  closed.segments.push_back(line);
  numbers.push_back(subpath.segments.size());
  return closed;
}

/// Turned round where the samples run the other way. The first segment then ends where it started.
Subpath directed(const Subpath& closed, const Contour& samples, std::vector<std::size_t>& numbers) {
  if ((signed_area(closed) < 0) == (signed_area(samples) < 0)) return closed;
  // The segment that is now the first starts where the first one started before.
  std::reverse(numbers.begin() + 1, numbers.end());
  return reversed(closed);
}

double turn_between(const BezierSegment& before, const BezierSegment& after) {
  const Eigen::Vector2d a = end_direction(before), b = start_direction(after);
  return std::abs(arctangent(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

}  // namespace

AnchoredPath::AnchoredPath(const Subpath& subpath, const Contour& samples)
    : numbers_(segments_with_length(subpath)),
      closed_(directed(closed_path(subpath, numbers_), samples, numbers_)),
      arc_(closed_) {
  const BezierSegment* before = &closed_.segments.back();
  for (std::size_t i = 0; i < closed_.segments.size(); ++i) {
    const BezierSegment& segment = closed_.segments[i];
    vertices_.push_back({numbers_[i], segment.control.col(0), arc_.start_of(i),
                         turn_between(*before, segment) > anchor_corner});
    before = &segment;
  }
}

std::vector<double> AnchoredPath::lengths_between(const std::vector<std::size_t>& anchors) const {
  std::vector<double> lengths;
  for (std::size_t k = 0; k < anchors.size(); ++k) {
    const double from = vertices_[anchors[k]].length;
    const double to = vertices_[anchors[(k + 1) % anchors.size()]].length;
    lengths.push_back(to > from ? to - from : to - from + length());
  }
  return lengths;
}

Contour AnchoredPath::points(const std::vector<std::size_t>& anchors,
                             const std::vector<Index>& counts) const {
  const std::vector<double> lengths = lengths_between(anchors);
  Index rows = 0;
  for (const Index count : counts) rows += count;
  Contour points(rows, 2);
  Index row = 0;
  for (std::size_t k = 0; k < anchors.size(); ++k) {
    const PathVertex& anchor = vertices_[anchors[k]];
    points.row(row++) = anchor.point;
    for (Index i = 1; i < counts[k]; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(counts[k]);
      const double at = anchor.length + share * lengths[k];
      points.row(row++) = arc_.point(at < length() ? at : at - length());
    }
  }
  return points;
}

}  // namespace wavecurve
