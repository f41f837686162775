#include "wavecurve/io/drawings/detail/svg/tidy_outline.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve::io {

namespace {

void refuse_large(const BezierSegment& segment) {
  for (double value : segment.control.reshaped()) {
    if (std::abs(value) <= largest_coordinate) continue;
    throw std::invalid_argument(
        fmt::format("coordinate {:g} is not within +-{:g}", value, largest_coordinate));
  }
}

Eigen::AlignedBox2d box_of(const Subpath& subpath) {
  Eigen::AlignedBox2d box;
  for (const BezierSegment& segment : subpath.segments) {
    for (Eigen::Index i = 0; i < segment.control.cols(); ++i) box.extend(segment.control.col(i));
  }
  return box;
}

bool is_point(const BezierSegment& segment) {
  return (segment.control.colwise() - segment.control.col(0)).isZero(0);
}

void join_ends(Subpath& subpath) {
  const double tolerance = 1e-10 * box_of(subpath).diagonal().norm();
  auto& segments = subpath.segments;
  const Eigen::Vector2d start = segments.front().control.col(0);
  const auto& last = segments.back().control;
  const bool short_closing = subpath.closed && segments.size() > 1 && last.cols() == 2 &&
                             (last.col(0) - last.col(1)).norm() <= tolerance;
  if (short_closing) segments.pop_back();
  auto end = segments.back().control.rightCols<1>();
  if ((end - start).norm() > tolerance) return;
  end = start;
  subpath.closed = true;
}

}  // namespace

bool has_no_length(const Subpath& subpath) {
  const Eigen::AlignedBox2d box = box_of(subpath);
  if (box.isEmpty()) return true;
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return box.diagonal().norm() <= 1e-12 * std::max(1.0, largest);
}

void lengthen_dots(std::vector<Subpath>& subpaths, double length) {
  for (Subpath& subpath : subpaths) {
    if (!has_no_length(subpath) || subpath.segments.empty()) continue;
    BezierSegment line;
    line.control.resize(2, 2);
    line.control.colwise() = subpath.segments.front().control.col(0).eval();
    line.control(0, 1) += length;
    subpath = {{line}, false};
  }
}

void close_areas(std::vector<Subpath>& subpaths) {
  std::erase_if(subpaths, [](const Subpath& subpath) {
    return subpath.segments.size() == 1 && subpath.segments.front().degree() == 1;
  });
  for (Subpath& subpath : subpaths) {
    if (subpath.closed) continue;
    BezierSegment closing;
    closing.control.resize(2, 2);
    closing.control << subpath.segments.back().control.rightCols<1>(),
        subpath.segments.front().control.leftCols<1>();
    subpath.segments.push_back(closing);
    subpath.closed = true;
  }
}

void transform_outline(std::vector<Subpath>& subpaths, const Eigen::Affine2d& transform) {
  for (Subpath& subpath : subpaths) {
    for (BezierSegment& segment : subpath.segments) {
      segment.control =
          ((transform.linear() * segment.control).colwise() + transform.translation()).eval();
      refuse_large(segment);
    }
    if (has_no_length(subpath)) continue;
    std::erase_if(subpath.segments, is_point);
    join_ends(subpath);
  }
}

}  // namespace wavecurve::io
