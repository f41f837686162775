#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/path.hpp"

namespace wavecurve {

/// The length of a segment, the integral of |B'(s)| over 0 <= s <= 1, to a relative 1e-12, cusps
/// and nearly degenerate segments included.
double arc_length(const BezierSegment& segment);

/// The sum over the segments.
double arc_length(const Subpath& subpath);

/// A subpath parametrised by its arc length. Publication, section 2.2: t(l) = l / L.
///
/// The segments are halved until Gauss-Legendre quadrature of a part and of its two halves agree;
/// a length is inverted on its part by Newton's method, kept inside a bracket by bisection.
class ArcLength {
 public:
  /// Throws std::invalid_argument where there is no segment, and where the length is zero or not
  /// finite.
  explicit ArcLength(const Subpath& subpath);

  double length() const { return length_; }
  /// Arc length from the start of the subpath to that of a segment.
  double start_of(std::size_t segment) const { return starts_[segment]; }
  /// The point at arc length l, 0 <= l <= length(), to a few roundings of the coordinates and of
  /// the length; beyond that, the nearest end.
  Eigen::Vector2d point(double l) const;

 private:
  struct Part {
    std::size_t segment = 0;
    double begin = 0, end = 1;  ///< of the segment's parameter
    double start = 0, length = 0;
  };

  std::vector<BezierSegment> segments_;
  std::vector<double> starts_;
  std::vector<Part> parts_;
  double length_ = 0;
};

}  // namespace wavecurve
