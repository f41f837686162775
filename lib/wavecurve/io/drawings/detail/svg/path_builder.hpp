#pragma once

#include <utility>
#include <vector>

#include "wavecurve/curves/path.hpp"

namespace wavecurve::io {

/// Collects the segments of a path, in absolute coordinates, as the commands of SVG path data
/// demand: a command after a closing one starts a new subpath where the closed one starts.
/// A subpath without a drawing command leaves nothing.
class PathBuilder {
 public:
  void move_to(const Eigen::Vector2d& to);
  void line_to(const Eigen::Vector2d& to);
  void quadratic_to(const Eigen::Vector2d& control, const Eigen::Vector2d& to);
  void cubic_to(const Eigen::Vector2d& first, const Eigen::Vector2d& second,
                const Eigen::Vector2d& to);
  void close();
  /// Puts the end of the last segment exactly there, where it is but for rounding.
  void move_end(const Eigen::Vector2d& to);

  const Eigen::Vector2d& current() const { return current_; }
  std::vector<Subpath> take() { return std::move(subpaths_); }

 private:
  void append(const BezierSegment& segment);

  std::vector<Subpath> subpaths_;
  Eigen::Vector2d start_ = Eigen::Vector2d::Zero(), current_ = Eigen::Vector2d::Zero();
  bool drawing_ = false, moved_ = false;
};

}  // namespace wavecurve::io
