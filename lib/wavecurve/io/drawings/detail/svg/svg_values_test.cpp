#include "wavecurve/io/drawings/detail/svg/svg_values.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"

namespace wavecurve::io {
namespace {

using Eigen::Vector2d;
using test::path_of;

void expect_controls(const BezierSegment& segment, std::initializer_list<Vector2d> expected) {
  ASSERT_EQ(segment.control.cols(), static_cast<Eigen::Index>(expected.size()));
  Eigen::Index i = 0;
  for (const Vector2d& point : expected) EXPECT_EQ(segment.control.col(i++), point);
}

TEST(PathData, LinesInEveryForm) {
  const auto path = path_of("M1 2L3 4l1 1H9h-2V20v-3 20 21m1 1 2 0");
  ASSERT_EQ(path.size(), 2U);
  EXPECT_FALSE(path[0].closed);
  const auto& lines = path[0].segments;
  ASSERT_EQ(lines.size(), 8U);
  expect_controls(lines[0], {{1, 2}, {3, 4}});
  expect_controls(lines[1], {{3, 4}, {4, 5}});
  expect_controls(lines[2], {{4, 5}, {9, 5}});
  expect_controls(lines[3], {{9, 5}, {7, 5}});
  expect_controls(lines[4], {{7, 5}, {7, 20}});
  expect_controls(lines[5], {{7, 20}, {7, 17}});
  expect_controls(lines[7], {{7, 37}, {7, 58}});
  expect_controls(path[1].segments.at(0), {{8, 59}, {10, 59}});
}

TEST(PathData, CurvesKeepTheirDegreeAndReflectTheirControls) {
  const auto path = path_of("M0 0C1 2 3 4 5 6S7 8 9 10s1 1 2 2Q1 1 2 3T4 5t1 0q1 1 2 0");
  const auto& curves = path.at(0).segments;
  ASSERT_EQ(curves.size(), 7U);
  expect_controls(curves[0], {{0, 0}, {1, 2}, {3, 4}, {5, 6}});
  expect_controls(curves[1], {{5, 6}, {7, 8}, {7, 8}, {9, 10}});
  expect_controls(curves[2], {{9, 10}, {11, 12}, {10, 11}, {11, 12}});
  expect_controls(curves[3], {{11, 12}, {1, 1}, {2, 3}});
  expect_controls(curves[4], {{2, 3}, {3, 5}, {4, 5}});
  expect_controls(curves[5], {{4, 5}, {5, 5}, {5, 5}});
  expect_controls(curves[6], {{5, 5}, {6, 6}, {7, 5}});
}

TEST(PathData, RelativeCurvesStartAtTheCurrentPoint) {
  const auto path = path_of("M10 20c1 2 3 4 5 6 1 1 2 2 3 3");
  expect_controls(path.at(0).segments.at(0), {{10, 20}, {11, 22}, {13, 24}, {15, 26}});
  expect_controls(path[0].segments.at(1), {{15, 26}, {16, 27}, {17, 28}, {18, 29}});
}

TEST(PathData, ASmoothCommandAfterAnotherKindReflectsNothing) {
  const auto path = path_of("M0 0Q1 1 2 0S4 4 5 5M0 0C1 1 2 2 3 0T9 9");
  expect_controls(path.at(0).segments.at(1), {{2, 0}, {2, 0}, {4, 4}, {5, 5}});
  expect_controls(path.at(1).segments.at(1), {{3, 0}, {3, 0}, {9, 9}});
}

TEST(PathData, ClosingReturnsToTheStartAndTheNextCommandStartsThere) {
  const auto path = path_of("M10 10h5v5zl-5 -5M50 50H60V60H50V50Z");
  ASSERT_EQ(path.size(), 3U);
  EXPECT_TRUE(path[0].closed);
  EXPECT_EQ(path[0].segments.size(), 3U);
  expect_controls(path[0].segments[2], {{15, 15}, {10, 10}});
  EXPECT_FALSE(path[1].closed);
  expect_controls(path[1].segments.at(0), {{10, 10}, {5, 5}});
  EXPECT_TRUE(path[2].closed);
  EXPECT_EQ(path[2].segments.size(), 4U) << "the closing line has no length";
}

TEST(PathData, NumbersNeedNoSeparators) {
  const auto path = path_of("M.5.25L1e1-2.5E-1,+3-.5");
  expect_controls(path.at(0).segments.at(0), {{0.5, 0.25}, {10, -0.25}});
  expect_controls(path[0].segments.at(1), {{10, -0.25}, {3, -0.5}});
}

TEST(PathData, DecimalsAreRoundedCorrectly) {
  const auto path = path_of("M0.1 123.456L1e-3 0.30000000000000004");
  expect_controls(path.at(0).segments.at(0), {{0.1, 123.456}, {1e-3, 0.30000000000000004}});
}

TEST(PathData, MovesAloneLeaveNothing) { EXPECT_EQ(path_of("M1 1M2 2L3 3M4 4").size(), 1U); }

TEST(PathData, RadiiOfArcsLoseTheirSigns) {
  const auto expect_same = [](const std::string& data, const std::string& plain) {
    const auto found = path_of(data), wanted = path_of(plain);
    ASSERT_EQ(found.at(0).segments.size(), wanted.at(0).segments.size()) << data;
    for (std::size_t i = 0; i < wanted[0].segments.size(); ++i) {
      EXPECT_EQ(found[0].segments[i].control, wanted[0].segments[i].control) << data;
    }
  };
  const std::string plain = "M70 50A20 20 180 0 0 30 50A20 20 180 1 0 -70 -50Z";
  expect_same("M70 50A-20 20 180 0 0 30 50A-20-20 180 1 0-70-50Z", plain);
  expect_same("M70 50A20-20 180 00 30 50 20,-2e1 180 10-70-50Z", plain);
  expect_same("m70 50l-5-5a-5-5 0 015.5.5-5-5 0 01-1-1", "m70 50l-5-5a5 5 0 015.5.5 5 5 0 01-1-1");
}

TEST(PathData, WhatComesBeforeADefectIsKept) {
  PathBuilder path;
  EXPECT_THROW(parse_path_data("M0 0L5 5 6 6 7", path), std::invalid_argument);
  EXPECT_THROW(parse_path_data("M0 0H5V1e99999", path), std::invalid_argument);
  EXPECT_NO_THROW(parse_path_data(" none ", path));
  const auto kept = path.take();
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].segments.size(), 2U);
  EXPECT_EQ(kept[1].segments.size(), 1U);
}

TEST(PathData, RefusalsCountTheCharacters) {
  PathBuilder path;
  const auto refused = [&](const char* text) {
    return test::refusal([&] { parse_path_data(text, path); });
  };
  EXPECT_EQ(refused("M0 0L5 5 X"), "no path data after 9 characters, at 'X'");
  EXPECT_EQ(refused("L5 5"), "no path data after 0 characters, at 'L5 5'");
  EXPECT_EQ(refused("M0 0L1 nan"), "no path data after 4 characters, at 'L1 nan'");
  EXPECT_EQ(refused("M0 0L1"), "no path data after 4 characters, at 'L1'");
  EXPECT_EQ(refused(("M0 " + std::string(101, '1')).c_str()).substr(0, 45),
            "more than 100 digits in a row after 3 charact");
  EXPECT_EQ(refused("M0 1e-12345"),
            "more than 4 digits in a row after 3 characters, at '1e-12345'");
  EXPECT_EQ(test::refusal([&] { parse_points("1,2 3", path); }),
            "no list of points after 4 characters, at '3'");
}

TEST(Transform, TheProductActsFromTheRight) {
  const Eigen::Affine2d both = parse_transform("translate(10, 20) scale(2)");
  test::expect_near(both * Vector2d(1, 1), 12, 22, 0);
  test::expect_near(parse_transform("matrix(1 2 3 4 5 6)") * Vector2d(1, 10), 36, 48, 0);
  test::expect_near(parse_transform("rotate(90)") * Vector2d(1, 0), 0, 1, 1e-15);
  test::expect_near(parse_transform("rotate(90 10 10)") * Vector2d(11, 10), 10, 11, 1e-14);
  test::expect_near(parse_transform("skewX(45),skewY(0)") * Vector2d(0, 1), 1, 1, 1e-15);
  test::expect_near(parse_transform("skewY(45)") * Vector2d(1, 0), 1, 1, 1e-15);
  test::expect_near(parse_transform("scale(2 -3)translate(1)") * Vector2d(0, 1), 2, -3, 0);
  EXPECT_EQ(test::refusal([] { parse_transform("rotate(90 1)"); }),
            "no transformation after 0 characters, at 'rotate(90 1)'");
}

}  // namespace
}  // namespace wavecurve::io
