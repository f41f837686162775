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
                               "0 0\n10   0\n10 10\n",
                               "0\t0\n10\t0\n10\t10\n",
                               "0;0\n10;0\n10;10\n",
                               "sep=;\n0,0;0\n10,0;0\n1,0e1;10\n",
                               "x,y\r0,0\r10,0\r10,10\r",
                               "\"0\",\"0\"\n\"10\",\"0\"\n\"10\",\"10\"\n",
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

using Warned = std::vector<std::string>;

/// The corners 0,0 10,0 10,10 of a triangle, in their order.
void expect_triangle(const std::string& text, const Warned& warnings = {}) {
  const DrawingFile file = read_points(text);
  EXPECT_EQ(file.warnings, warnings) << text;
  const auto& subpaths = file.drawing.layers.at(0).subpaths;
  ASSERT_EQ(subpaths.size(), 1U) << text;
  ASSERT_EQ(subpaths[0].segments.size(), 3U) << text;
  test::expect_near(subpaths[0].segments[1].control.col(0), 10, 0, 0);
  test::expect_near(subpaths[0].segments[2].control.col(0), 10, 10, 0);
}

TEST(ReadPoints, ColumnsAreReadByTheirNames) {
  expect_triangle("y,x\n0,0\n0,10\n10,10\n");
  expect_triangle("\"Y\";\"X\"\n0;0\n0;10\n10;10\n");
  expect_triangle("X (mm)\tY (mm)\n0\t0\n10\t0\n10\t10\n");
  expect_triangle("y [px],x [px]\n0,0\n0,10\n10,10\n");
  expect_triangle("pos_y,pos_x\n0,0\n0,10\n10,10\n");
  expect_triangle("YCoord,XCoord\n0,0\n0,10\n10,10\n");
  expect_triangle("lat,lon\n0,0\n0,10\n10,10\n");
  expect_triangle("row,col\n0,0\n0,10\n10,10\n");
  expect_triangle("# y x\n0 0\n0 10\n10 10\n");  // as NumPy writes it
  expect_triangle("# a comment, no header\n0,0\n10,0\n10,10\n");
  expect_triangle("x,y,x_world\n0,0,5\n10,0,6\n10,10,7\n", {"the column 'x_world' is not read"});
}

TEST(ReadPoints, WhatNumbersThePointsIsNoContour) {
  expect_triangle(",x,y\n0,0,0\n1,10,0\n2,10,10\n");                          // pandas
  expect_triangle("\"\",\"x\",\"y\"\n\"1\",0,0\n\"2\",10,0\n\"3\",10,10\n");  // R
  expect_triangle(" \tX\tY\n1\t0\t0\n2\t10\t0\n3\t10\t10\n");                 // ImageJ
  expect_triangle(
      "\"x\" \"y\"\n\"a\" 0 0\n\"b\" 10 0\n\"c\" 10 10\n",  // R's write.table
      {"the header names 2 columns of 3: the first is taken for the names of the lines"});
  expect_triangle(",0,1\n0,0.0,0.0\n1,10.0,0.0\n2,10.0,10.0\n",
                  {"the columns '0' and '1' are taken for x and y"});
  expect_triangle("index,y,x\n0,0,0\n1,0,10\n2,10,10\n");
  expect_triangle("1,0,0\n2,10,0\n3,10,10\n");
  expect_triangle("id,x,y\n7,0,0\n8,10,0\n9,10,10\n",
                  {"the column 'id' differs in all lines: it is taken for the name of each point"});
  expect_triangle("k,x,y\n2,0,0\n1,10,0\n3,10,10\n",
                  {"line 3: points are taken in the order of the lines, not of the column 'k'"});
}

TEST(ReadPoints, WhatIsNotReadIsNamed) {
  expect_triangle("x,y,z\n0,0,0\n10,0,0\n10,10,0\n",
                  {"the column z is not read: a drawing is plane"});
  expect_triangle("Area,X,Y,Mean\n5,0,0,1\n6,10,0,1\n7,10,10,1\n",
                  {"the columns 'Area', 'Mean' are not read"});
  expect_triangle("V1,V2\n0,0\n10,0\n10,10\n", {"the columns 'V1' and 'V2' are taken for x and y"});
  expect_triangle("frame,x,y\n3,0,0\n3,10,0\n3,10,10\n");  // one frame is a drawing
}

TEST(ReadPoints, ColumnsMakeContoursWhereverTheyStand) {
  const std::string rows = "0,0,a\n9,0,a\n9,9,a\n3,3,b\n6,3,b\n6,6,b\n";
  for (const std::string name : {"id", "contour", "Name", "label", "polygon_id", "Shape"}) {
    EXPECT_EQ(layer("x,y," + name + "\n" + rows).subpaths.size(), 2U) << name;
  }
  EXPECT_EQ(layer(",x,y\n0,0,0\n0,9,0\n0,9,9\n1,3,3\n1,6,3\n1,6,6\n").subpaths.size(), 2U);
  const DrawingFile mixed = read_points("id,x,y\na,0,0\nb,3,3\na,9,0\nb,6,3\na,9,9\nb,6,6\n");
  EXPECT_EQ(mixed.drawing.layers.at(0).subpaths.size(), 2U);
  EXPECT_EQ(mixed.warnings, Warned{"line 4: a contour goes on that another one has interrupted"});
  const DrawingFile anew = read_points("k,x,y\n0,0,0\n1,9,0\n2,9,9\n0,3,3\n1,6,3\n2,6,6\n");
  EXPECT_EQ(anew.drawing.layers.at(0).subpaths.size(), 2U);
  EXPECT_EQ(anew.warnings, Warned{"line 5: the numbers in the column 'k' begin anew: taken for "
                                  "another contour"});
}

TEST(ReadPoints, BlankLinesSeparateContours) {
  EXPECT_EQ(layer("0,0\n9,0\n9,9\n\n\n3,3\n6,3\n6,6\n").subpaths.size(), 2U);
  EXPECT_EQ(layer("x,y\n\n0,0\n9,0\n9,9\n,\n3,3\n6,3\n6,6\n").subpaths.size(), 2U);
  EXPECT_EQ(layer("0,0\n9,0\n9,9\n# no gap\n0,9\n").subpaths.size(), 1U);
  EXPECT_EQ(layer("0,0\n\n9,0\n\n9,9\n\n0,9\n").subpaths.at(0).segments.size(), 4U);
}

TEST(ReadPoints, OpenContoursAreLines) {
  const Drawing arc =
      read_points("0,0\n10,0\n10,50\n\n0,60\n0,100\n9,100\n", {.open = true}).drawing;
  ASSERT_EQ(arc.layers.at(0).subpaths.size(), 2U);
  EXPECT_FALSE(arc.layers[0].subpaths[0].closed);
  EXPECT_EQ(arc.layers[0].subpaths[0].segments.size(), 2U);
  EXPECT_FALSE(arc.layers[0].paint.fill);
  EXPECT_TRUE(arc.layers[0].paint.stroke);
  EXPECT_DOUBLE_EQ(arc.layers[0].paint.stroke_width, 1);
  EXPECT_TRUE(
      read_points("0,0\n9,0\n9,9\n0,0\n", {.open = true}).drawing.layers[0].subpaths[0].closed);
}

TEST(ReadPoints, YMayPointUp) {
  const Drawing up = read_points("0,0\n10,0\n10,10\n", {.y_up = true}).drawing;
  EXPECT_DOUBLE_EQ(test::area_of(up.layers.at(0).subpaths), -50);
  EXPECT_EQ(up.view_box, (ViewBox{0, -10, 10, 10}));
}

TEST(ReadPoints, AContourOfTooFewPointsIsSkipped) {
  const DrawingFile file = read_points("a,0,0\na,9,0\na,9,9\nb,3,3\nc,4,4\nc,4,4\n");
  EXPECT_EQ(file.drawing.layers.at(0).subpaths.size(), 1U);
  EXPECT_EQ(file.warnings,
            Warned{"2 contours of 3 have fewer than 3 points, or no length, and are skipped"});
}

TEST(ReadPoints, RefusalsNameTheLine) {
  EXPECT_EQ(refused(""), "no points");
  EXPECT_EQ(refused("x,y\n"), "no points");
  EXPECT_EQ(refused("0,0\n1,0\n1,two\n"), "line 3: 'two' is no number within +-1e+09");
  EXPECT_EQ(refused("0,0\nnan,0\n"), "line 2: 'nan' is no number within +-1e+09");
  EXPECT_EQ(refused("0,0\ninf,0\n"), "line 2: 'inf' is no number within +-1e+09");
  EXPECT_EQ(refused("0,0\n1e308,0\n"), "line 2: '1e308' is no number within +-1e+09");
  EXPECT_EQ(refused("0,0\n1,2,3\n"), "line 2: '1,2,3' has 3 entries, the first line has 2");
  EXPECT_EQ(refused("y,x\n1,2\n3\n"), "line 3: '3' has 1 entry, the header has 2");
  EXPECT_EQ(refused("1\n"), "line 1: '1' has 1 entry, and no header names x and y");
  EXPECT_EQ(refused("1,2,3,4\n"), "line 1: '1,2,3,4' has 4 entries, and no header names x and y");
  EXPECT_EQ(refused("x,y\nx,y\n"), "line 2: 'x' is no number within +-1e+09");
  EXPECT_EQ(refused("3,4\n"), "no contour has the 3 points that it needs");
  EXPECT_EQ(refused("3,4\n3,4\n3,4\n"), "the points have no length: all are one");
  EXPECT_EQ(refused(std::string("\xff\xfe"
                                "1\0,\0",
                                6)),
            "the text is UTF-16; save it as UTF-8");
}

TEST(ReadPoints, WhatCannotBeKnownIsRefused) {
  EXPECT_EQ(refused("t,x,y\n0,0,0\n1,9,0\n2,9,9\n"),
            "the column 't' changes: the table is a record in time, but a drawing stands still; "
            "'wavecurve gait fit' reads records");
  EXPECT_EQ(refused("x,z\n0,0\n1,9\n"), "'x,z' names no column y");
  EXPECT_EQ(refused("width,height\n0,0\n1,9\n"), "'width,height' names no column x and none y");
  EXPECT_EQ(refused("x_a,y_a,x_b,y_b\n0,0,0,0\n"),
            "'x_a,y_a,x_b,y_b' names no column x and none y");
  EXPECT_EQ(refused("x_mm,x_px,y\n0,0,0\n"), "two columns are x: 'x_mm' and 'x_px'");
  const std::string guess =
      "line 1: three columns, and no header that says what they are, as "
      "contour,x,y does";
  EXPECT_EQ(refused("0,0,0\n10,0,0\n10,10,0\n"), guess);                    // x,y,z
  EXPECT_EQ(refused("5,6,0\n7,8,0\n9,8,0\n5,5,1\n6,8,1\n9,9,1\n"), guess);  // x,y,id
}

TEST(ReadPoints, PointsAreBounded) {
  std::string many;
  for (int i = 0; i <= 4'000'000; ++i) many += "1,2\n";
  EXPECT_EQ(refused(many), "line 4000001: '1,2' is one of more than 4000000 points");
}

}  // namespace
}  // namespace wavecurve::io
