#include "wavecurve/curves/fit_cubics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve {
namespace {

constexpr double pi = std::numbers::pi;

/// A closed curve of a few harmonics with random phases: smooth, different each time.
Contour random_curve(Eigen::Index points) {
  Contour contour = Contour::Zero(points, 2);
  for (int harmonic = 1; harmonic <= 5; ++harmonic) {
    const double phase = *rc::gen::inRange(0, 628) / 100.0, size = 10.0 / (harmonic * harmonic);
    for (Eigen::Index i = 0; i < points; ++i) {
      const double angle = harmonic * 2 * pi * static_cast<double>(i) / static_cast<double>(points);
      contour(i, 0) += size * std::cos(angle + phase);
      contour(i, 1) += size * std::sin(angle);
    }
  }
  return contour;
}

Contour square(Eigen::Index side) {
  Contour contour(4 * side, 2);
  for (Eigen::Index i = 0; i < side; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(side);
    contour.row(i) << s, 0;
    contour.row(side + i) << 1, s;
    contour.row(2 * side + i) << 1 - s, 1;
    contour.row(3 * side + i) << 0, 1 - s;
  }
  return contour;
}

Eigen::RowVector2d on_cubic(const Contour& control, Eigen::Index row, double s) {
  const double r = 1 - s;
  return r * r * r * control.row(row) + 3 * r * r * s * control.row(row + 1) +
         3 * r * s * s * control.row(row + 2) + s * s * s * control.row((row + 3) % control.rows());
}

/// The largest distance of a point from the curve, found without the fit's parameters: the curve is
/// walked in steps so small that they matter only in the digits behind the tolerances asked for.
double distance(const Contour& points, const Contour& control) {
  double largest = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (Eigen::Index row = 0; row < control.rows(); row += 3) {
      for (int step = 0; step <= 200; ++step) {
        nearest = std::min(nearest, (on_cubic(control, row, step / 200.0) - points.row(i)).norm());
      }
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// Half the longest step of that walk: a nearest point is that close to one looked at.
double step_of_walk(const Contour& control) {
  double longest = 0;
  for (Eigen::Index row = 0; row < control.rows(); row += 3) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      longest = std::max(
          longest, (control.row((row + k + 1) % control.rows()) - control.row(row + k)).norm());
    }
  }
  return 3 * longest / 200 / 2;  // the derivative of a cubic is at most 3 times its longest leg
}

RC_GTEST_PROP(FitCubics, HoldsTheToleranceAtTheKeysAndAtEveryTimeBetween, ()) {
  const double tolerance = *rc::gen::element(0.3, 0.05, 0.01);
  const std::vector<Contour> keys{random_curve(64), random_curve(64), square(16) * 10};
  const std::vector<Contour> fits = fit_cubics(keys, tolerance);
  RC_ASSERT(fits.size() == 3U);
  for (int k = 0; k < 2; ++k) {
    for (double share : {0.0, 0.3, 0.5, 1.0}) {
      const Contour points = (1 - share) * keys[k] + share * keys[k + 1];
      const Contour control = (1 - share) * fits[k] + share * fits[k + 1];
      RC_ASSERT(distance(points, control) <= tolerance + step_of_walk(control));
    }
  }
}

TEST(FitCubics, NeedsFewVertices) {
  Contour circle(256, 2);
  for (int i = 0; i < 256; ++i) {
    circle.row(i) << std::cos(2 * pi * i / 256), std::sin(2 * pi * i / 256);
  }
  // A cubic that meets the circle and its tangent at both ends of an angle h is off by at most
  // h^4 / 384 at equal parameters: 9.9e-4 with 8 vertices, 6.2e-5 with 16.
  EXPECT_EQ(fit_cubics({circle}, 1e-3)[0].rows(), 3 * 8);
  EXPECT_EQ(fit_cubics({circle}, 1e-4)[0].rows(), 3 * 16);
}

TEST(FitCubics, IsSmoothAtVerticesOfASmoothCurve) {
  Contour ellipse(256, 2);
  for (int i = 0; i < 256; ++i) {
    ellipse.row(i) << 3 * std::cos(2 * pi * i / 256), std::sin(2 * pi * i / 256);
  }
  const Contour control = fit_cubics({ellipse}, 1e-4)[0];
  for (Eigen::Index row = 0; row < control.rows(); row += 3) {
    const Eigen::RowVector2d before =
        control.row(row) - control.row((row + control.rows() - 1) % control.rows());
    const Eigen::RowVector2d after = control.row(row + 1) - control.row(row);
    const double turn = before.x() * after.y() - before.y() * after.x();
    EXPECT_NEAR(turn / (before.norm() * after.norm()), 0, 1e-12);
  }
}

TEST(FitCubics, KeepsCornersAndStraightEdges) {
  const Contour control = fit_cubics({square(16)}, 1e-9)[0];
  ASSERT_EQ(control.rows(), 3 * 4);
  for (int corner = 0; corner < 4; ++corner) {
    EXPECT_EQ(control.row(3 * corner), square(16).row(16 * corner));
  }
  EXPECT_LT(distance(square(16), control), 1e-9 + step_of_walk(control));
}

TEST(FitCubics, DropsVerticesThatHalvingLeft) {
  // A rectangle whose corners lie between points: only at these is it not straight.
  Contour rectangle(1000, 2);
  for (int i = 0; i < 1000; ++i) {
    const double at = 0.37 + i;
    rectangle.row(i) << (at < 400   ? at
                         : at < 500 ? 400
                         : at < 900 ? 900 - at
                                    : 0),
        (at < 400   ? 0
         : at < 500 ? at - 400
         : at < 900 ? 100
                    : 1000 - at);
  }
  const Contour control = fit_cubics({rectangle}, 0.05)[0];
  EXPECT_LE(control.rows(), 3 * 20);
  EXPECT_LT(distance(rectangle, control), 0.05 + step_of_walk(control));
}

TEST(FitCubics, TakesWhatHasNoShape) {
  EXPECT_EQ(fit_cubics({Contour::Zero(1, 2)}, 0.1)[0].rows(), 3);
  EXPECT_TRUE(fit_cubics({Contour::Ones(64, 2)}, 0.1)[0].isOnes(1e-12));
  const Contour there_and_back = (Contour(4, 2) << 0, 0, 1, 0, 2, 0, 1, 0).finished();
  EXPECT_LT(distance(there_and_back, fit_cubics({there_and_back}, 1e-3)[0]), 2e-2);
}

TEST(FitCubics, RefusesKeysThatDoNotBelongTogether) {
  EXPECT_THROW(fit_cubics({square(4), square(5)}, 0.1), std::invalid_argument);
  EXPECT_THROW(fit_cubics({}, 0.1), std::invalid_argument);
  EXPECT_THROW(fit_cubics({Contour(0, 2)}, 0.1), std::invalid_argument);
  EXPECT_THROW(fit_cubics({square(4)}, -1), std::invalid_argument);
}

TEST(FitCubics, EndWithTheLastPointOfAnOpenLine) {
  // A line with a corner, and a quarter of a circle.
  Contour corner(9, 2), arc(65, 2);
  for (Eigen::Index i = 0; i < 9; ++i) {
    const auto way = static_cast<double>(i);
    corner.row(i) << std::min(way, 4.0), std::max(0.0, way - 4);
  }
  for (Eigen::Index i = 0; i < 65; ++i) {
    const double angle = std::numbers::pi / 2 * static_cast<double>(i) / 64;
    arc.row(i) << std::cos(angle), std::sin(angle);
  }
  const Contour bent = fit_cubics({corner}, 1e-6, Closing::open)[0];
  EXPECT_EQ(bent.rows() % 3, 1);
  EXPECT_EQ(bent.row(0), corner.row(0));
  EXPECT_EQ(bent.bottomRows(1), corner.bottomRows(1));
  bool has_corner = false;
  for (Eigen::Index row = 0; row < bent.rows(); row += 3) {
    has_corner = has_corner || bent.row(row) == corner.row(4);
  }
  EXPECT_TRUE(has_corner);
  for (Eigen::Index row = 0; row < bent.rows(); ++row) {
    EXPECT_NEAR(std::min(std::abs(bent(row, 1)), std::abs(bent(row, 0) - 4)), 0, 1e-6) << row;
  }
  const Contour quarter = fit_cubics({arc}, 1e-3, Closing::open)[0];
  EXPECT_LE(quarter.rows(), 13);
  EXPECT_EQ(quarter.bottomRows(1), arc.bottomRows(1));
  EXPECT_THROW(fit_cubics({Contour::Zero(1, 2)}, 1, Closing::open), std::invalid_argument);
}

// The directions about a point are roundings: they make no corners.
TEST(FitCubics, HaveFewVerticesForWhatShrinksToAPoint) {
  Contour line(257, 2), point(257, 2);
  for (Eigen::Index i = 0; i < 257; ++i) {
    const double share = static_cast<double>(i) / 256, noise = i % 3 == 0 ? 1e-15 : -1e-15;
    line.row(i) << 10 * share, 5 * share;
    point.row(i) << 5 + noise, 2.5 - 2 * noise;
  }
  EXPECT_LE(fit_cubics({line, point}, 0.01, Closing::open)[0].rows(), 13);
}

}  // namespace
}  // namespace wavecurve
