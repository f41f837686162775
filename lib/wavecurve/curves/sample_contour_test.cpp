#include "wavecurve/curves/sample_contour.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/curves/detail/arc_length.hpp"
#include "wavecurve/curves/detail/bezier.hpp"
#include "wavecurve/curves/signed_area.hpp"

namespace wavecurve {
namespace {

/// Lengths are exact to a relative 1e-12; the few contours here are of length 1 to 100.
constexpr double tolerance = 1e-11;

Contour points(std::initializer_list<Eigen::RowVector2d> rows) {
  Contour result(static_cast<Eigen::Index>(rows.size()), 2);
  Eigen::Index i = 0;
  for (const Eigen::RowVector2d& row : rows) result.row(i++) = row;
  return result;
}

/// Clockwise as seen, y pointing down; perimeter 14.
const Contour rectangle = points({{0, 0}, {4, 0}, {4, 3}, {0, 3}});

BezierSegment cubic(Eigen::Vector2d a, Eigen::Vector2d b, Eigen::Vector2d c, Eigen::Vector2d d) {
  BezierSegment segment;
  segment.control.resize(2, 4);
  segment.control << a, b, c, d;
  return segment;
}

/// A smooth closed curve of two cubics, clockwise.
Subpath lens() {
  return {{cubic({0, 0}, {0, -4}, {10, -3}, {10, 0}), cubic({10, 0}, {10, 2}, {0, 5}, {0, 0})},
          true};
}

Contour reversed_rows(const Contour& contour) { return contour.colwise().reverse(); }

TEST(SampleContour, IsUniformInArcLength) {
  const Contour samples = sample_contour(rectangle, 8);
  const Contour expected =
      points({{0, 0}, {1.75, 0}, {3.5, 0}, {4, 1.25}, {4, 3}, {2.25, 3}, {0.5, 3}, {0, 1.75}});
  EXPECT_LE((samples - expected).cwiseAbs().maxCoeff(), tolerance);
  const ArcLength arc(lens());
  const Contour curve = sample_contour(lens(), 64);
  for (Eigen::Index i = 0; i < 64; ++i) {
    const Eigen::Vector2d expected_point = arc.point(static_cast<double>(i) / 64 * arc.length());
    EXPECT_LE((curve.row(i).transpose() - expected_point).norm(), tolerance) << i;
  }
}

TEST(SampleContour, IsClockwise) {
  EXPECT_EQ(signed_area(rectangle), 12);
  EXPECT_EQ(signed_area(reversed_rows(rectangle)), -12);
  EXPECT_GT(signed_area(lens()), 0);
  const Contour samples = sample_contour(lens(), 64);
  EXPECT_GT(signed_area(samples), 0);
  const Contour turned = sample_contour(reversed(lens()), 64);
  EXPECT_LE((samples - turned).cwiseAbs().maxCoeff(), tolerance);
}

/// The exact area is the limit of the polygons': they miss the square of the spacing.
TEST(SignedArea, IsTheLimitOfPolygonsForCurves) {
  const double area = signed_area(lens());
  const double coarse = signed_area(sample_contour(lens(), 512)) - area;
  const double fine = signed_area(sample_contour(lens(), 1024)) - area;
  EXPECT_LE(std::abs(fine), 1e-4 * area);
  EXPECT_NEAR(coarse / fine, 4, 0.1);
}

TEST(SampleContour, RunsThroughAnOpenStrokeThereAndBack) {
  Subpath stroke = lens();
  stroke.segments.pop_back();
  stroke.closed = false;
  const Contour samples = sample_contour(stroke, 64);
  EXPECT_EQ(samples.row(0), Eigen::RowVector2d(0, 0));
  EXPECT_LE((samples.row(32) - Eigen::RowVector2d(10, 0)).norm(), tolerance);
  for (Eigen::Index i = 1; i < 32; ++i) {
    EXPECT_LE((samples.row(i) - samples.row(64 - i)).norm(), tolerance) << i;
  }
}

TEST(SampleContour, KeepsCorners) {
  const Contour samples = sample_contour(rectangle, 8, Corners::kept);
  // 8 points for lengths 4, 3, 4, 3: 2.29 and 1.71 points, rounded to 2 each.
  const Contour expected =
      points({{0, 0}, {2, 0}, {4, 0}, {4, 1.5}, {4, 3}, {2, 3}, {0, 3}, {0, 1.5}});
  EXPECT_LE((samples - expected).cwiseAbs().maxCoeff(), tolerance);
  const Contour four = sample_contour(rectangle, 4, Corners::kept);
  EXPECT_EQ(four, rectangle);
}

TEST(SampleContour, SharesPointsAmongPiecesByLength) {
  const Contour needle = points({{0, 0}, {100, 0}, {100, 0.001}});
  const Contour samples = sample_contour(needle, 64, Corners::kept);
  for (const Eigen::RowVector2d& corner :
       {Eigen::RowVector2d(0, 0), Eigen::RowVector2d(100, 0), Eigen::RowVector2d(100, 0.001)}) {
    EXPECT_EQ((samples.rowwise() - corner).rowwise().norm().minCoeff(), 0) << corner;
  }
  // One point for the short side; the long ones differ by one point at most.
  Eigen::Index on_axis = (samples.col(1).array() == 0).count();
  EXPECT_TRUE(on_axis == 32 || on_axis == 33) << on_axis;
}

/// Also with as many points as corners, a quarter of a million of them, in about linear time.
TEST(SampleContour, KeepsEveryCornerOfAComb) {
  for (Eigen::Index teeth : {2, 50, 1 << 17}) {
    Contour comb(2 * teeth, 2);
    for (Eigen::Index i = 0; i < 2 * teeth; ++i) {
      // Teeth of one size, or of every size.
      const double x = teeth == 50 ? static_cast<double>(i * i) : static_cast<double>(i);
      comb.row(i) << x, (i % 2 == 0 ? 0 : teeth == 50 ? x : 1);
    }
    comb.row(0) << 0, 2 * comb.col(0).maxCoeff();  // where it is held, which makes it clockwise
    const Eigen::Index samples = teeth == 50 ? 128 : 2 * teeth;
    const Contour found = sample_contour(comb, samples, Corners::kept);
    Eigen::Index row = 0;
    for (Eigen::Index i = 0; i < comb.rows(); ++i, ++row) {
      while (row < samples && found.row(row) != comb.row(i)) ++row;
      ASSERT_LT(row, samples) << teeth << " " << i;
    }
  }
}

TEST(SampleContour, FindsNoCornersOnASmoothCurve) {
  EXPECT_EQ(sample_contour(lens(), 32, Corners::kept), sample_contour(lens(), 32));
}

TEST(SampleContour, KeepsTheEndsOfAStroke) {
  Subpath stroke = polygon(rectangle);
  stroke.closed = false;
  stroke.segments.pop_back();
  const Contour samples = sample_contour(stroke, 32, Corners::kept);
  EXPECT_EQ((samples.rowwise() - rectangle.row(3)).rowwise().norm().minCoeff(), 0);
}

TEST(SampleLayer, KeepsTheDirectionOfHoles) {
  Layer layer;
  const Contour hole = points({{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  layer.subpaths = {polygon(hole), polygon(reversed_rows(rectangle))};
  const std::vector<Contour> contours = sample_layer(layer, 16);
  EXPECT_LT(signed_area(contours[0]), 0);
  EXPECT_GT(signed_area(contours[1]), 0);
}

TEST(SampleLayer, ClosesWhatIsFilled) {
  Subpath open = polygon(rectangle);
  open.closed = false;
  open.segments.pop_back();
  Layer layer;
  layer.subpaths = {open};
  layer.paint.stroke = Colour{};
  EXPECT_NEAR(signed_area(sample_layer(layer, 16)[0]), 0, tolerance);
  layer.paint.fill = Colour{};
  const Contour filled = sample_layer(layer, 16)[0];
  EXPECT_LE((filled - sample_contour(rectangle, 16)).cwiseAbs().maxCoeff(), tolerance);
}

void expect_refusal(const Subpath& subpath, Eigen::Index samples, Corners corners,
                    const std::string& text) {
  try {
    sample_contour(subpath, samples, corners);
    ADD_FAILURE() << text;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(SampleContour, RefusesBadInput) {
  const Subpath good = polygon(rectangle);
  for (Eigen::Index samples : {-4, 0, 1, 2, 12, 1 << 25}) {
    expect_refusal(
        good, samples, Corners::ignored,
        "samples is " + std::to_string(samples) + ", but must be a power of two from 4 to");
  }
  expect_refusal(polygon(points({{1, 2}})), 8, Corners::ignored, "length of a contour is 0");
  expect_refusal(polygon(points({{1, 2}, {1, 2}, {1, 2}})), 8, Corners::kept,
                 "length of a contour is 0");
  expect_refusal(polygon(points({{0, 0}, {2, 0}, {2, 2}, {1, 3}, {0, 2}})), 4, Corners::kept,
                 "samples is 4, but must be at least 5");
  Layer layer;
  layer.id = "nose";
  layer.subpaths = {polygon(points({{1, 2}}))};
  try {
    sample_layer(layer, 8);
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("layer nose: ")) << error.what();
  }
}

}  // namespace
}  // namespace wavecurve
