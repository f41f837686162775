#include "wavecurve/io/drawings/detail/svg/path_builder.hpp"

namespace wavecurve::io {

void PathBuilder::move_to(const Eigen::Vector2d& to) {
  start_ = current_ = to;
  drawing_ = false;
  moved_ = true;
}

void PathBuilder::line_to(const Eigen::Vector2d& to) {
  BezierSegment segment;
  segment.control.resize(2, 2);
  segment.control << current_, to;
  append(segment);
}

void PathBuilder::quadratic_to(const Eigen::Vector2d& control, const Eigen::Vector2d& to) {
  BezierSegment segment;
  segment.control.resize(2, 3);
  segment.control << current_, control, to;
  append(segment);
}

void PathBuilder::cubic_to(const Eigen::Vector2d& first, const Eigen::Vector2d& second,
                           const Eigen::Vector2d& to) {
  BezierSegment segment;
  segment.control.resize(2, 4);
  segment.control << current_, first, second, to;
  append(segment);
}

void PathBuilder::close() {
  if (!drawing_ && !moved_) return;
  if (!drawing_) line_to(start_);  // a dot, where its stroke has caps
  if (current_ != start_) line_to(start_);
  subpaths_.back().closed = true;
  drawing_ = false;
}

void PathBuilder::move_end(const Eigen::Vector2d& to) {
  if (drawing_) subpaths_.back().segments.back().control.rightCols<1>() = to;
  current_ = to;
}

void PathBuilder::append(const BezierSegment& segment) {
  if (!drawing_) subpaths_.emplace_back();
  drawing_ = true;
  moved_ = false;
  subpaths_.back().segments.push_back(segment);
  current_ = segment.control.rightCols<1>();
}

}  // namespace wavecurve::io
