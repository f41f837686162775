#include "wavecurve/curves/detail/arc_length.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/quadrature/gauss.hpp>

#include "wavecurve/curves/detail/bezier.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

namespace {

/// Gauss-Legendre quadrature on [-1, 1].
struct Quadrature {
  static constexpr int size = 15;
  using Nodes = Eigen::Array<double, size, 1>;
  Nodes nodes, weights;

  static const Quadrature& rule() {
    static const Quadrature the_rule;
    return the_rule;
  }

 private:
  Quadrature() {
    using Rule = boost::math::quadrature::gauss<double, size>;
    constexpr int middle = size / 2;  // the rule lists the nodes from zero on
    for (int i = 0; i <= middle; ++i) {
      const auto at = static_cast<std::size_t>(i);
      nodes[middle + i] = Rule::abscissa()[at];
      nodes[middle - i] = -Rule::abscissa()[at];
      weights[middle + i] = weights[middle - i] = Rule::weights()[at];
    }
  }
};

/// |B'(s)|, from control points that are padded to three: the Bernstein form keeps its accuracy
/// where B' is small.
class Speed {
 public:
  explicit Speed(const BezierSegment& segment) {
    const auto control = hodograph(segment);
    if (segment.degree() == 3) {
      control_ = control;
    } else {
      const auto first = control.col(0), last = control.col(control.cols() - 1);
      control_ << first, (first + last) / 2, last;
    }
  }

  double operator()(double s) const {
    const Eigen::Vector3d bernstein((1 - s) * (1 - s), 2 * s * (1 - s), s * s);
    return (control_ * bernstein).norm();
  }

  double integral(double begin, double end) const {
    const Quadrature& rule = Quadrature::rule();
    const double half = (end - begin) / 2;
    const Nodes s = begin + half + half * rule.nodes, r = 1 - s;
    const Nodes b0 = r * r, b1 = 2 * r * s, b2 = s * s;
    const auto component = [&](int i) {
      return control_(i, 0) * b0 + control_(i, 1) * b1 + control_(i, 2) * b2;
    };
    const Nodes x = component(0), y = component(1);
    return half * (rule.weights * (x * x + y * y).sqrt()).sum();
  }

 private:
  using Nodes = Quadrature::Nodes;
  Eigen::Matrix<double, 2, 3> control_;
};

struct Range {
  double begin, end, length;
};

/// Halves the range until its length and the sum of its halves' differ by the tolerance at most;
/// the sum is then nearer still. At a cusp, where the speed is like |s|, a range's share of the
/// length falls with the square of its width, so that the depth suffices.
void append_parts(const Speed& speed, const Range& whole, double tolerance, int depth,
                  std::vector<Range>& parts) {
  const double middle = (whole.begin + whole.end) / 2;
  const Range left{whole.begin, middle, speed.integral(whole.begin, middle)};
  const Range right{middle, whole.end, speed.integral(middle, whole.end)};
  const double difference = std::abs(left.length + right.length - whole.length);
  if (!(difference > tolerance) || depth == 0) {  // a NaN stays one part
    parts.push_back({whole.begin, whole.end, left.length + right.length});
    return;
  }
  append_parts(speed, left, tolerance, depth - 1, parts);
  append_parts(speed, right, tolerance, depth - 1, parts);
}

std::vector<Range> parts_of(const BezierSegment& segment) {
  constexpr int largest_depth = 48;
  // The control polygon is at most a few times longer than the curve, as both are norms of B'. What
  // is left out at a cusp's two sides adds up geometrically, to a few tolerances.
  constexpr double relative_tolerance = 1e-14;
  const Speed speed(segment);
  if (segment.degree() == 1) return {{0, 1, speed(0)}};
  const double polygon = hodograph(segment).colwise().norm().sum() / segment.degree();
  std::vector<Range> parts;
  append_parts(speed, {0, 1, speed.integral(0, 1)}, relative_tolerance * polygon, largest_depth,
               parts);
  return parts;
}

/// Where the target would be if the parameter were a cubic function of the length, with the right
/// derivatives 1 / speed at the ends; limited, so that it grows, to three times the mean.
double first_guess(const Speed& speed, const Range& range, double target) {
  const double width = range.end - range.begin, x = target / range.length, y = 1 - x;
  const double limit = 3 * width;
  const double slope_begin = std::min(range.length / speed(range.begin), limit);
  const double slope_end = std::min(range.length / speed(range.end), limit);
  const double share = x * x * (3 - 2 * x) * width + x * y * (y * slope_begin - x * slope_end);
  return range.begin + std::clamp(share, 0.0, width);
}

/// The s in the range whose length from begin is the target: Newton's method, and bisection where
/// that would leave the bracket.
double invert(const Speed& speed, const Range& range, double target) {
  constexpr double precision = 1e-14;
  constexpr int largest_count = 64;  // bisections that use up every bit
  double low = range.begin, high = range.end;
  double s = first_guess(speed, range, target);
  double excess = speed.integral(low, s) - target;
  for (int i = 0; i < largest_count && std::abs(excess) > precision * range.length; ++i) {
    (excess > 0 ? high : low) = s;
    const double newton = s - excess / speed(s);
    const double next = newton > low && newton < high ? newton : (low + high) / 2;
    excess += speed.integral(s, next);
    s = next;
  }
  return s;
}

}  // namespace

double arc_length(const BezierSegment& segment) {
  double length = 0;
  for (const Range& part : parts_of(segment)) length += part.length;
  return length;
}

double arc_length(const Subpath& subpath) {
  double length = 0;
  for (const BezierSegment& segment : subpath.segments) length += arc_length(segment);
  return length;
}

ArcLength::ArcLength(const Subpath& subpath) : segments_(subpath.segments) {
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    starts_.push_back(length_);
    for (const Range& part : parts_of(segments_[i])) {
      parts_.push_back({i, part.begin, part.end, length_, part.length});
      length_ += part.length;
    }
  }
  check_above_zero("the length of a contour", length_);
}

Eigen::Vector2d ArcLength::point(double l) const {
  const auto after =
      std::upper_bound(parts_.begin(), parts_.end(), l,
                       [](double length, const Part& part) { return length < part.start; });
  const Part& part = after == parts_.begin() ? parts_.front() : *(after - 1);
  const BezierSegment& segment = segments_[part.segment];
  const double target = std::clamp(l - part.start, 0.0, part.length);
  if (segment.degree() == 1) {
    return bezier_point(segment, part.length > 0 ? target / part.length : 0);
  }
  return bezier_point(segment, invert(Speed(segment), {part.begin, part.end, part.length}, target));
}

}  // namespace wavecurve
