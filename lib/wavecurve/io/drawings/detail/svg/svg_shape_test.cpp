#include "wavecurve/io/drawings/detail/svg/svg_shape.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"

namespace wavecurve::io {
namespace {

constexpr double pi = std::numbers::pi;
// The radius of an arc is at most 9.1e-11 too large, its area at most twice that.
constexpr double arc_tolerance = 2e-10;

std::vector<Subpath> outline(const std::string& shape) { return test::only_layer(shape).subpaths; }

TEST(Shape, ARectangleHasFourLinesClockwise) {
  const auto path = outline("<rect x='10' y='20' width='30' height='5'/>");
  ASSERT_EQ(path.size(), 1U);
  EXPECT_TRUE(path[0].closed);
  EXPECT_EQ(path[0].segments.size(), 4U);
  EXPECT_DOUBLE_EQ(test::area_of(path), 150);
  EXPECT_EQ(test::box_of(path).min(), Eigen::Vector2d(10, 20));
  EXPECT_EQ(test::box_of(path).max(), Eigen::Vector2d(40, 25));
}

TEST(Shape, RoundedCornersTakeTheirShareOfTheArea) {
  // One radius given stands for both; each is at most half of the side.
  const auto expect_area = [](const std::string& radii, double rx, double ry) {
    const auto path = outline("<rect width='30' height='20' " + radii + "/>");
    const double area = 600 - (4 - pi) * rx * ry;
    EXPECT_NEAR(test::area_of(path), area, 600 * arc_tolerance) << radii;
    EXPECT_TRUE(path.at(0).closed);
    EXPECT_NEAR(test::box_of(path).sizes().x(), 30, 1e-8);
    EXPECT_NEAR(test::box_of(path).sizes().y(), 20, 1e-8);
  };
  expect_area("rx='3' ry='2'", 3, 2);
  expect_area("rx='4'", 4, 4);
  expect_area("ry='4'", 4, 4);
  expect_area("rx='99'", 15, 10);
  expect_area("rx='3' ry='0'", 0, 0);
  expect_area("rx='auto' ry='5'", 5, 5);
}

TEST(Shape, CirclesAndEllipses) {
  const auto circle = outline("<circle cx='50' cy='40' r='10'/>");
  EXPECT_NEAR(test::area_of(circle), 100 * pi, 100 * pi * arc_tolerance);
  EXPECT_TRUE(circle.at(0).closed);
  for (const BezierSegment& segment : circle[0].segments) {
    EXPECT_NEAR((test::point_at(segment, 0.3) - Eigen::Vector2d(50, 40)).norm(), 10, 1e-9);
  }
  const auto ellipse = outline("<ellipse cx='50' cy='40' rx='10' ry='3'/>");
  EXPECT_NEAR(test::area_of(ellipse), 30 * pi, 30 * pi * arc_tolerance);
  EXPECT_NEAR(test::area_of(outline("<ellipse rx='4'/>")), 16 * pi, 16 * pi * arc_tolerance);
}

TEST(Shape, LinesPolylinesAndPolygons) {
  const auto line = outline("<line x1='1' y1='2' x2='3' y2='50%' stroke='red'/>");
  ASSERT_EQ(line.at(0).segments.size(), 1U);
  EXPECT_FALSE(line[0].closed);
  EXPECT_EQ(test::point_at(line[0].segments[0], 1), Eigen::Vector2d(3, 50));
  const auto polyline = outline("<polyline points=' 0,0 10,0\n10 10 ' fill='none' stroke='red'/>");
  EXPECT_EQ(polyline.at(0).segments.size(), 2U);
  EXPECT_FALSE(polyline[0].closed);
  const auto polygon = outline("<polygon points='0,0 10,0 10,10'/>");
  EXPECT_TRUE(polygon.at(0).closed);
  EXPECT_DOUBLE_EQ(test::area_of(polygon), 50);
}

TEST(Shape, LengthsHaveUnitsAndPercentages) {
  const auto box = test::box_of(outline("<rect x='1in' y='10%' width='25.4mm' height='3pt'/>"));
  EXPECT_NEAR(box.min().x(), 96, 1e-12);
  EXPECT_NEAR(box.min().y(), 10, 1e-12);
  EXPECT_NEAR(box.sizes().x(), 96, 1e-12);
  EXPECT_NEAR(box.sizes().y(), 4, 1e-12);
}

TEST(Shape, WhatIsBrokenNamesTheAttribute) {
  const auto refused = [](const char* text) { return test::refusal([&] { outline(text); }); };
  EXPECT_EQ(refused("<circle id='c' r='-3'/>"),
            "nothing is painted: line 1: circle 'c': r -3 is below 0");
  EXPECT_EQ(refused("<rect width='nan' height='1'/>"),
            "nothing is painted: line 1: rect: width 'nan' is no finite length");
  EXPECT_EQ(refused("<rect width='1e300' height='1'/>"),
            "nothing is painted: line 1: rect: coordinate 1e+300 is not within +-1e+09");
}

}  // namespace
}  // namespace wavecurve::io
