#include "wavecurve/io/drawings/detail/read_points.hpp"

#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"

namespace wavecurve::io {
namespace {

Layer layer(const std::string& text) { return read_points(text).drawing.layers.at(0); }

std::string refused(const std::string& text) {
  return test::refusal([&] { read_points(text); });
}

TEST(ReadPoints, OneClosedContour) {
  const Layer square = layer("0,0\n10,0\n10,10\n0,10\n");
  EXPECT_EQ(square.id, "contour");
  EXPECT_TRUE(square.paint.fill);
  ASSERT_EQ(square.subpaths.size(), 1U);
  EXPECT_TRUE(square.subpaths[0].closed);
  EXPECT_EQ(square.subpaths[0].segments.size(), 4U);
  EXPECT_DOUBLE_EQ(test::area_of(square.subpaths), 100);
  EXPECT_EQ(read_points("5,6\n15,6\n10,10").drawing.view_box, (ViewBox{5, 6, 10, 4}));
}

TEST(ReadPoints, TheFormIsForgiving) {
  const std::string forms[] = {"x,y\n0,0\n10,0\n10,10\n",
                               "0,0\r\n10,0\r\n10,10\r\n",
                               "\xef\xbb\xbfx,y\n0,0\n10,0\n10,10",
                               "# three\n\n 0 , 0 # here\n+1e1,0\n\n10.0,1.0e+1",
                               "0 0\n10\t0\n10;10\n",
                               "0,0\n10,0\n10,10\n0,0\n"};
  for (const std::string& form : forms) {
    const Layer triangle = layer(form);
    EXPECT_EQ(triangle.subpaths.at(0).segments.size(), 3U) << form;
    EXPECT_DOUBLE_EQ(test::area_of(triangle.subpaths), 50) << form;
  }
}

TEST(ReadPoints, AFirstColumnNamesContours) {
  const Layer ring = layer("contour,x,y\na,0,0\na,9,0\na,9,9\na,0,9\nb,3,3\nb,3,6\nb,6,6\nb,6,3\n");
  ASSERT_EQ(ring.subpaths.size(), 2U);
  EXPECT_EQ(ring.paint.fill_rule, FillRule::evenodd);
  EXPECT_DOUBLE_EQ(test::area_of(ring.subpaths), 72);
  EXPECT_EQ(layer("0,0,0\n0,9,0\n0,9,9\n1,3,3\n1,3,6\n1,6,6\n").subpaths.size(), 2U);
}

TEST(ReadPoints, AContourOfOnePointIsSkipped) {
  const DrawingFile file = read_points("a,0,0\na,9,0\na,9,9\nb,3,3\nc,4,4\nc,4,4\n");
  EXPECT_EQ(file.drawing.layers.at(0).subpaths.size(), 1U);
  EXPECT_EQ(file.warnings, std::vector<std::string>{"2 contours of 3 have no length"});
}

TEST(ReadPoints, RefusalsNameTheLine) {
  EXPECT_EQ(refused(""), "no points");
  EXPECT_EQ(refused("x,y\n"), "no points");
  EXPECT_EQ(refused("0,0\n1,0\n1,two\n"), "line 3: 'two' is no number within +-1e+09");
  EXPECT_EQ(refused("0,0\nnan,0\n"), "line 2: 'nan' is no number within +-1e+09");
  EXPECT_EQ(refused("0,0\ninf,0\n"), "line 2: 'inf' is no number within +-1e+09");
  EXPECT_EQ(refused("0,0\n1e308,0\n"), "line 2: '1e308' is no number within +-1e+09");
  EXPECT_EQ(refused("0,0\n1,2,3\n"), "line 2: '1,2,3' is not x,y or contour,x,y");
  EXPECT_EQ(refused("1\n"), "line 1: '1' is not x,y or contour,x,y");
  EXPECT_EQ(refused("x,y\nx,y\n"), "line 2: 'x' is no number within +-1e+09");
  EXPECT_EQ(refused("3,4\n"), "the points have no length: all are one");
  EXPECT_EQ(refused("3,4\n3,4\n"), "the points have no length: all are one");
}

}  // namespace
}  // namespace wavecurve::io
