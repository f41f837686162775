#include "wavecurve/curves/sample_contour.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/curves/detail/arc_length.hpp"
#include "wavecurve/curves/detail/bezier.hpp"
#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;

constexpr double corner_angle = std::numbers::pi / 9;

BezierSegment line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  BezierSegment segment;
  segment.control.resize(2, 2);
  segment.control << from, to;
  return segment;
}

bool is_point(const BezierSegment& segment) {
  return (segment.control.colwise() - segment.control.col(0)).isZero(0);
}

Subpath there_and_back(Subpath subpath) {
  const Subpath back = reversed(subpath);
  subpath.segments.insert(subpath.segments.end(), back.segments.begin(), back.segments.end());
  subpath.closed = true;
  return subpath;
}

Subpath closed_by_line(Subpath subpath) {
  const Eigen::Vector2d start = subpath.segments.front().control.col(0);
  const Eigen::Vector2d end = subpath.segments.back().control.rightCols(1);
  if (start != end) subpath.segments.push_back(line(end, start));
  subpath.closed = true;
  return subpath;
}

double turn(const BezierSegment& before, const BezierSegment& after) {
  const Eigen::Vector2d a = end_direction(before), b = start_direction(after);
  return std::abs(arctangent(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

/// Indices of the segments that a corner precedes.
std::vector<std::size_t> corners_of(const Subpath& closed) {
  std::vector<std::size_t> corners;
  const BezierSegment* before = &closed.segments.back();
  for (std::size_t i = 0; i < closed.segments.size(); ++i) {
    if (turn(*before, closed.segments[i]) > corner_angle) corners.push_back(i);
    before = &closed.segments[i];
  }
  return corners;
}

Contour sample_uniformly(const Subpath& closed, Index samples) {
  const ArcLength arc(closed);
  Contour points(samples, 2);
  for (Index i = 0; i < samples; ++i) {
    points.row(i) = arc.point(static_cast<double>(i) / static_cast<double>(samples) * arc.length());
  }
  return points;
}

Contour sample_with_corners(const Subpath& closed, Index samples) {
  const std::vector<std::size_t> corners = corners_of(closed);
  if (corners.empty()) return sample_uniformly(closed, samples);
  if (static_cast<Index>(corners.size()) > samples) {
    throw std::invalid_argument(
        must_be("samples", samples,
                fmt::format("at least {}, the number of corners to keep", corners.size())));
  }
  const ArcLength arc(closed);
  std::vector<double> lengths(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool last = i + 1 == corners.size();
    const double end =
        last ? arc.start_of(corners[0]) + arc.length() : arc.start_of(corners[i + 1]);
    lengths[i] = end - arc.start_of(corners[i]);
  }
  const std::vector<Index> counts = shares_of_samples(lengths, samples);
  Contour points(samples, 2);
  Index row = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    points.row(row++) = closed.segments[corners[i]].control.col(0);
    for (Index k = 1; k < counts[i]; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(counts[i]);
      const double l = arc.start_of(corners[i]) + share * lengths[i];
      points.row(row++) = arc.point(l < arc.length() ? l : l - arc.length());
    }
  }
  return points;
}

/// A closed subpath without segments that are points, which have no direction.
Subpath prepared(Subpath subpath) {
  std::erase_if(subpath.segments, is_point);
  if (subpath.segments.empty()) {
    throw std::invalid_argument(must_be("the length of a contour", 0, "above 0"));
  }
  return subpath.closed ? closed_by_line(std::move(subpath)) : there_and_back(std::move(subpath));
}

Contour sample(const Subpath& closed, Index samples, Corners corners) {
  return corners == Corners::kept ? sample_with_corners(closed, samples)
                                  : sample_uniformly(closed, samples);
}

}  // namespace

void check_samples(Index samples) {
  if (samples < fewest_samples || samples > most_samples || !is_power_of_two(samples)) {
    throw std::invalid_argument(
        must_be("samples", samples,
                fmt::format("a power of two from {} to {}", fewest_samples, most_samples)));
  }
}

Contour sample_contour(const Subpath& subpath, Index samples, Corners corners) {
  check_samples(samples);
  const Subpath closed = prepared(subpath);
  const bool clockwise = !subpath.closed || signed_area(closed) >= 0;
  return sample(clockwise ? closed : reversed(closed), samples, corners);
}

Contour sample_contour(const Contour& points, Index samples, Corners corners) {
  return sample_contour(polygon(points), samples, corners);
}

std::vector<Contour> sample_layer(const Layer& layer, Index samples, Corners corners) try {
  check_samples(samples);
  std::vector<Subpath> closed;
  double largest_area = 0;
  for (Subpath subpath : layer.subpaths) {
    subpath.closed = subpath.closed || layer.paint.fill.has_value();
    closed.push_back(prepared(std::move(subpath)));
    const double area = signed_area(closed.back());
    if (std::abs(area) > std::abs(largest_area)) largest_area = area;
  }
  std::vector<Contour> contours;
  for (const Subpath& subpath : closed) {
    contours.push_back(sample(largest_area >= 0 ? subpath : reversed(subpath), samples, corners));
  }
  return contours;
} catch (const std::invalid_argument& error) {
  throw std::invalid_argument(fmt::format("layer {}: {}", layer.id, error.what()));
}

std::vector<Index> shares_of_samples(const std::vector<double>& lengths, Index samples) {
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  std::vector<Index> count(lengths.size());
  std::vector<double> wanted(lengths.size());
  for (std::size_t i = 0; i < count.size(); ++i) {
    wanted[i] = lengths[i] / total * static_cast<double>(samples);
    count[i] = std::max<Index>(1, static_cast<Index>(wanted[i]));
  }
  Index left = samples - std::accumulate(count.begin(), count.end(), Index{0});
  const int step = left > 0 ? 1 : -1;
  std::priority_queue<std::pair<double, std::size_t>> queue;
  const auto enqueue = [&](std::size_t i) {
    if (count[i] + step >= 1) queue.push({step * (wanted[i] - static_cast<double>(count[i])), i});
  };
  for (std::size_t i = 0; i < count.size(); ++i) enqueue(i);
  for (; left != 0; left -= step) {
    const std::size_t chosen = queue.top().second;
    queue.pop();
    count[chosen] += step;
    enqueue(chosen);
  }
  return count;
}

Subpath polygon(const Contour& points) {
  Subpath subpath;
  for (Index i = 1; i < points.rows(); ++i) {
    subpath.segments.push_back(line(points.row(i - 1), points.row(i)));
  }
  subpath.closed = true;
  return subpath.segments.empty() ? subpath : closed_by_line(std::move(subpath));
}

}  // namespace wavecurve
