#include "wavecurve/curves/detail/arc_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "wavecurve/curves/detail/bezier.hpp"

namespace wavecurve {
namespace {

constexpr double demanded = 1e-12;

BezierSegment segment(std::initializer_list<Eigen::Vector2d> points) {
  BezierSegment result;
  result.control.resize(2, static_cast<Eigen::Index>(points.size()));
  Eigen::Index i = 0;
  for (const Eigen::Vector2d& point : points) result.control.col(i++) = point;
  return result;
}

Subpath one(const BezierSegment& bezier) { return {{bezier}, false}; }

double coordinate() { return *rc::gen::inRange(-1000, 1001) / 64.0; }
Eigen::Vector2d anywhere() { return {coordinate(), coordinate()}; }

/// The length of the parabola with B' = a + s b, in long double: with s = u - a.b / b.b the speed
/// is |b| sqrt(u^2 + h^2), h = |a x b| / b.b.
double parabola_length(const BezierSegment& bezier) {
  const Eigen::Matrix<long double, 2, 3> p = bezier.control.cast<long double>();
  const Eigen::Matrix<long double, 2, 1> a = 2 * (p.col(1) - p.col(0));
  const Eigen::Matrix<long double, 2, 1> b = 2 * (p.col(2) - 2 * p.col(1) + p.col(0));
  const long double bb = b.squaredNorm();
  if (bb == 0) return static_cast<double>(a.norm());
  const long double h = std::abs(a.x() * b.y() - a.y() * b.x()) / bb, u = a.dot(b) / bb;
  const auto primitive = [h](long double x) {
    const long double log_term = h == 0 ? 0 : h * h * std::asinh(x / h);
    return (x * std::hypot(x, h) + log_term) / 2;
  };
  return static_cast<double>(std::sqrt(bb) * (primitive(u + 1) - primitive(u)));
}

TEST(ArcLength, IsTheChordOfALine) {
  const BezierSegment line = segment({{1, 2}, {4, -2}});
  EXPECT_EQ(arc_length(line), 5);
  const Eigen::Vector2d quarter = ArcLength(one(line)).point(1.25);
  EXPECT_EQ(quarter, Eigen::Vector2d(1.75, 1));
}

RC_GTEST_PROP(ArcLength, HasAClosedFormForAParabola, ()) {
  const BezierSegment bezier = segment({anywhere(), anywhere(), anywhere()});
  const double expected = parabola_length(bezier);
  RC_PRE(expected > 0);
  RC_ASSERT(std::abs(arc_length(bezier) - expected) <= demanded * expected);
}

/// Nearly collinear, turning back: a cusp that is just not one.
TEST(ArcLength, HasAClosedFormForNearlyDegenerateParabolas) {
  for (int e = 1; e <= 40; ++e) {
    const double height = std::ldexp(1.0, -e);
    const BezierSegment bezier = segment({{0, 0}, {3, height}, {1, 0}});
    const double expected = parabola_length(bezier);
    EXPECT_NEAR(arc_length(bezier), expected, demanded * expected) << e;
  }
}

/// (s^2, c s^3) for s = a .. b: speed |s| sqrt(4 + 9 c^2 s^2), a cusp at s = 0.
BezierSegment semicubical(double c, double a, double b) {
  const auto at = [&](double s) { return Eigen::Vector2d(s * s, c * s * s * s); };
  const auto slope = [&](double s) { return Eigen::Vector2d(2 * s, 3 * c * s * s); };
  const double third = (b - a) / 3;
  return segment({at(a), at(a) + third * slope(a), at(b) - third * slope(b), at(b)});
}

double semicubical_length(double c, double s) {
  const long double k = 9 * static_cast<long double>(c) * c, square = s * s;
  // ((4 + k s^2)^{3/2} - 8) / (3 k), without the cancellation for small k.
  const long double root = std::sqrt(4 + k * square);
  return static_cast<double>(square * (root * root + 2 * root + 4) / (3 * (root + 2)));
}

TEST(ArcLength, HasAClosedFormForACusp) {
  for (double c : {1.0, 0.25, 4.0, 1e-3, 1e-9}) {
    for (double a : {-1.0, -0.5, -0.0625, 0.0}) {
      const BezierSegment bezier = semicubical(c, a, 1);
      const double expected = semicubical_length(c, 1) + semicubical_length(c, a);
      EXPECT_NEAR(arc_length(bezier), expected, demanded * expected) << c << " " << a;
    }
  }
}

/// A Pythagorean hodograph, B' = (u^2 - v^2, 2 u v) with u, v linear: |B'| = u^2 + v^2. Where both
/// nearly vanish together, it nearly has a cusp.
struct Pythagorean {
  double u0, u1, v0, v1;

  BezierSegment bezier() const {
    const auto step = [](double u, double v, double x, double y) {
      return Eigen::Vector2d((u * x - v * y) / 3, (u * y + v * x) / 3);
    };
    const Eigen::Vector2d p1 = step(u0, v0, u0, v0), p2 = p1 + step(u0, v0, u1, v1);
    return segment({{0, 0}, p1, p2, p2 + step(u1, v1, u1, v1)});
  }
  double length_to(double s) const {
    const auto square = [s](double a, double b) {
      return s * (a * a + a * (b - a) * s + (b - a) * (b - a) * s * s / 3);
    };
    return square(u0, u1) + square(v0, v1);
  }
};

RC_GTEST_PROP(ArcLength, IsAPolynomialForAPythagoreanHodograph, ()) {
  const double small = std::ldexp(1.0, -*rc::gen::inRange(0, 30));
  const Pythagorean curve{coordinate(), coordinate(), small * coordinate(), small * coordinate()};
  const double length = curve.length_to(1);
  RC_PRE(length > 1e-3);
  const BezierSegment bezier = curve.bezier();
  RC_ASSERT(std::abs(arc_length(bezier) - length) <= demanded * length);
  const ArcLength arc(one(bezier));
  for (double s : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const double error = (arc.point(curve.length_to(s)) - bezier_point(bezier, s)).norm();
    RC_ASSERT(error <= demanded * length);
  }
}

/// Gauss-Legendre quadrature in long double on 2000 equal parts, or nothing where the speed falls
/// below 1 % of its largest: above it, the complex zeros of its square are several parts away.
/// Nearer to a cusp, the closed forms above are at hand.
std::optional<double> fine_length(const BezierSegment& bezier) {
  const Eigen::Matrix<long double, 2, 4> p = bezier.control.cast<long double>();
  const Eigen::Matrix<long double, 2, 3> d = 3 * (p.rightCols<3>() - p.leftCols<3>());
  const auto speed = [&](long double s) {
    const long double r = 1 - s;
    return (r * r * d.col(0) + 2 * r * s * d.col(1) + s * s * d.col(2)).eval().norm();
  };
  constexpr int parts = 2000;
  long double length = 0, slowest = speed(0), fastest = slowest;
  for (int i = 0; i < parts; ++i) {
    const long double begin = static_cast<long double>(i) / parts;
    const long double end = static_cast<long double>(i + 1) / parts;
    length += boost::math::quadrature::gauss<long double, 20>::integrate(speed, begin, end);
    slowest = std::min(slowest, speed(end));
    fastest = std::max(fastest, speed(end));
  }
  if (slowest < fastest / 100) return std::nullopt;
  return static_cast<double>(length);
}

RC_GTEST_PROP(ArcLength, AgreesWithFineQuadratureForACubic, ()) {
  const BezierSegment bezier = segment({anywhere(), anywhere(), anywhere(), anywhere()});
  const std::optional<double> expected = fine_length(bezier);
  RC_PRE(expected.has_value());
  RC_ASSERT(std::abs(arc_length(bezier) - *expected) <= demanded * *expected);
}

/// Collinear and overshooting at both ends: the distances between the turns add up.
TEST(ArcLength, CountsTheTurnsOfACollinearCubic) {
  const BezierSegment bezier = segment({{0, 0}, {4, 8}, {-3, -6}, {1, 2}});
  const auto x = [](double s) {
    return 12 * s * (1 - s) * (1 - s) - 9 * s * s * (1 - s) + s * s * s;
  };
  // x'(s) / 3 = 4 (1 - s)^2 - 14 s (1 - s) + 4 s^2 = 22 s^2 - 22 s + 4
  const double root = std::sqrt(22.0 * 22 - 4 * 22 * 4), low = (22 - root) / 44,
               high = (22 + root) / 44;
  const double expected = std::sqrt(5.0) * (x(low) + x(low) - x(high) + 1 - x(high));
  EXPECT_NEAR(arc_length(bezier), expected, demanded * expected);
}

/// Points at equal lengths are at equal distances along the curve, as its parts tell.
RC_GTEST_PROP(ArcLength, IsInverted, ()) {
  const BezierSegment bezier = segment({anywhere(), anywhere(), anywhere(), anywhere()});
  RC_PRE(arc_length(bezier) > 0);
  const ArcLength arc(one(bezier));
  const double s = *rc::gen::inRange(0, 1001) / 1000.0;
  // The part of the segment up to s, by de Casteljau's construction.
  const auto& p = bezier.control;
  const Eigen::Vector2d q0 = (1 - s) * p.col(0) + s * p.col(1);
  const Eigen::Vector2d q1 = (1 - s) * p.col(1) + s * p.col(2);
  const Eigen::Vector2d q2 = (1 - s) * p.col(2) + s * p.col(3);
  const Eigen::Vector2d r0 = (1 - s) * q0 + s * q1, r1 = (1 - s) * q1 + s * q2;
  const BezierSegment head = segment({p.col(0), q0, r0, (1 - s) * r0 + s * r1});
  const double error = (arc.point(arc_length(head)) - bezier_point(bezier, s)).norm();
  RC_ASSERT(error <= 2 * demanded * arc.length());
}

TEST(ArcLength, EndsAreTheControlPoints) {
  const BezierSegment bezier = segment({{0, 0}, {1, 3}, {5, 3}, {2, 1}});
  const ArcLength arc(one(bezier));
  EXPECT_EQ(arc.point(0), Eigen::Vector2d(0, 0));
  EXPECT_LE((arc.point(arc.length()) - Eigen::Vector2d(2, 1)).norm(), 1e-14 * arc.length());
  EXPECT_LE((arc.point(2 * arc.length()) - Eigen::Vector2d(2, 1)).norm(), 1e-14 * arc.length());
}

TEST(ArcLength, RefusesWhatHasNoLength) {
  EXPECT_THROW(ArcLength(Subpath{}), std::invalid_argument);
  EXPECT_THROW(ArcLength(one(segment({{1, 1}, {1, 1}, {1, 1}}))), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ArcLength(one(segment({{1, 1}, {nan, 1}, {1, 2}}))), std::invalid_argument);
  EXPECT_THROW(ArcLength(one(segment({{-1e308, 1}, {1e308, 1}}))), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
