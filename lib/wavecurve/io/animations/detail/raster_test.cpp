#include "wavecurve/io/animations/detail/raster.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/io/animations/animation_test.hpp"
#include "wavecurve/io/animations/detail/coverage.hpp"
#include "wavecurve/io/drawings/detail/stroke_polygons.hpp"

namespace wavecurve::io {
namespace {

double area(const std::vector<Contour>& polygons, FillRule rule, int size = 100) {
  Coverage coverage(size, size);
  coverage.fill(polygons, rule);
  double sum = 0;
  for (int y = coverage.first_row(); y < coverage.end_row(); ++y) {
    for (int x = 0; x < size; ++x) sum += static_cast<double>(coverage.row(y)[x]);
  }
  return sum;
}

Pen round_pen(double radius) { return {radius, LineCap::round, LineJoin::round, 4}; }

Contour rectangle(double left, double top, double right, double bottom) {
  return (Contour(4, 2) << left, top, right, top, right, bottom, left, bottom).finished();
}

TEST(Coverage, IsTheAreaOfAPolygon) {
  // Ordinates are sampled 16 times a pixel, abscissae are exact.
  EXPECT_NEAR(area({rectangle(10.3, 20.25, 40.8, 30.75)}, FillRule::nonzero), 30.5 * 10.5, 1e-3);
  const double radius = 40;
  const Contour circle = flower(50, 50, radius, 1000);
  EXPECT_NEAR(area({circle}, FillRule::nonzero), std::numbers::pi * radius * radius, 1);
}

TEST(Coverage, KnowsBothFillRules) {
  const Contour outer = rectangle(10, 10, 50, 50), inner = rectangle(20, 20, 40, 40);
  const Contour reversed = inner.colwise().reverse();
  EXPECT_NEAR(area({outer, inner}, FillRule::nonzero), 1600, 1e-2);
  EXPECT_NEAR(area({outer, inner}, FillRule::evenodd), 1200, 1e-2);
  EXPECT_NEAR(area({outer, reversed}, FillRule::nonzero), 1200, 1e-2);
  EXPECT_NEAR(area({outer, reversed}, FillRule::evenodd), 1200, 1e-2);
}

TEST(Coverage, IsCutAtTheBorders) {
  EXPECT_NEAR(area({rectangle(-1e9, -50, 10, 1e9)}, FillRule::nonzero), 1000, 1e-2);
  EXPECT_EQ(area({rectangle(-30, -30, -10, -10)}, FillRule::nonzero), 0);
  EXPECT_EQ(area({rectangle(200, 200, 300, 300)}, FillRule::nonzero), 0);
  EXPECT_EQ(area({}, FillRule::nonzero), 0);
}

TEST(Stroke, CoversWhatIsWithinItsRadius) {
  // A square of side 40 and a stroke of 10: corners outside are quarters of a disc.
  const double expected = 40 * 10 * 4 - 4 * 25 + std::numbers::pi * 25;
  EXPECT_NEAR(
      area(stroke_polygons({rectangle(30, 30, 70, 70)}, {}, round_pen(5)), FillRule::nonzero),
      expected, 2);
  // Points so dense that no turn shows must leave no gaps either.
  const Contour circle = flower(50, 50, 30, 2000);
  EXPECT_NEAR(area(stroke_polygons({circle}, {}, round_pen(5)), FillRule::nonzero),
              std::numbers::pi * (35 * 35 - 25 * 25), 3);
  const Contour point = Contour::Constant(8, 2, 50);
  EXPECT_NEAR(area(stroke_polygons({point}, {}, round_pen(10)), FillRule::nonzero),
              100 * std::numbers::pi, 3);
}

TEST(Stroke, JoinsAndCapsAreThoseOfThePen) {
  const auto stroked = [&](const Contour& line, bool open, const Pen& pen) {
    return area(stroke_polygons({line}, {open}, pen), FillRule::nonzero);
  };
  // The square of side 40 again: a miter is a corner's square, a bevel half of it.
  const Contour square = rectangle(30, 30, 70, 70);
  const double flat = 40 * 10 * 4 - 4 * 25;
  EXPECT_NEAR(stroked(square, false, {5, LineCap::butt, LineJoin::miter, 4}), flat + 100, 0.1);
  EXPECT_NEAR(stroked(square, false, {5, LineCap::butt, LineJoin::bevel, 4}), flat + 50, 1);
  // The miter of a right angle is sqrt 2 widths long.
  EXPECT_NEAR(stroked(square, false, {5, LineCap::butt, LineJoin::miter, 1.42}), flat + 100, 0.1);
  EXPECT_NEAR(stroked(square, false, {5, LineCap::butt, LineJoin::miter, 1.41}), flat + 50, 1);
  // The same square opened: three sides, whose ends begin with their caps.
  EXPECT_NEAR(stroked(square, true, {5, LineCap::butt, LineJoin::miter, 4}), 1200, 0.1);
  EXPECT_NEAR(stroked(square, true, {5, LineCap::square, LineJoin::miter, 4}), 1300, 0.1);
  EXPECT_NEAR(stroked(square, true, {5, LineCap::round, LineJoin::miter, 4}),
              1200 + 25 * std::numbers::pi, 2);
  // A line without length has its caps alone.
  const Contour point = Contour::Constant(8, 2, 50);
  EXPECT_EQ(stroked(point, true, {5, LineCap::butt, LineJoin::round, 4}), 0);
  EXPECT_NEAR(stroked(point, false, {5, LineCap::square, LineJoin::round, 4}), 100, 0.1);
  // There and back, a line turns with a miter beyond every limit: as its flat end.
  const Contour there_and_back = (Contour(2, 2) << 20, 50, 80, 50).finished();
  EXPECT_NEAR(stroked(there_and_back, false, {5, LineCap::butt, LineJoin::miter, 4}), 600, 0.1);
}

TEST(Render, MixesLayersInOrder) {
  Paint half = filled(0, 0, 1);
  half.fill_opacity = 0.5;
  const Raster raster = render({{"a", {rectangle(0, 0, 10, 10)}, filled(1, 0, 0)},
                                {"b", {rectangle(5, 0, 10, 10)}, half},
                                {"c", {rectangle(10, 0, 20, 10)}, half}},
                               {0, 0, 20, 10}, {40, 20});
  const auto pixel = [&](std::size_t x, std::size_t y) {
    const auto at = raster.rgba.begin() + static_cast<std::ptrdiff_t>(4 * (40 * y + x));
    return std::vector<int>(at, at + 4);
  };
  EXPECT_EQ(pixel(5, 10), (std::vector<int>{255, 0, 0, 255}));
  EXPECT_EQ(pixel(15, 10), (std::vector<int>{128, 0, 128, 255}));
  EXPECT_EQ(pixel(30, 10), (std::vector<int>{0, 0, 255, 128}));
}

TEST(Render, CentresTheViewBox) {
  const Raster raster =
      render({{"a", {rectangle(0, 0, 1, 1)}, filled(0, 0, 0)}}, {0, 0, 1, 1}, {30, 10});
  for (int x = 0; x < 30; ++x) {
    EXPECT_EQ(raster.rgba[static_cast<std::size_t>(4 * (30 * 5 + x) + 3)], x / 10 == 1 ? 255 : 0);
  }
}

TEST(Stroke, OfASmoothLineIsOnePolygon) {
  std::size_t vertices = 0;
  const Contour circle = flower(50, 50, 30, 1000);
  const std::vector<Contour> pieces =
      stroke_polygons({circle}, {}, {5, LineCap::butt, LineJoin::miter, 4});
  for (const Contour& polygon : pieces) vertices += static_cast<std::size_t>(polygon.rows());
  EXPECT_EQ(pieces.size(), 1U);
  EXPECT_EQ(vertices, 2 * 1001U);
  EXPECT_NEAR(area(pieces, FillRule::nonzero), std::numbers::pi * (35 * 35 - 25 * 25), 3);
}

TEST(Stroke, LeavesNoGapWhereALineBendsMoreSharplyThanThePenIsWide) {
  // A circle smaller than the pen's: all of it is covered, and nothing twice turned the other way.
  const Contour circle = flower(50, 50, 2, 200);
  EXPECT_NEAR(area(stroke_polygons({circle}, {}, round_pen(10)), FillRule::nonzero),
              std::numbers::pi * 144, 2);
}

TEST(RasterSize, IsThatOfTheOptions) {
  OutputOptions options;
  EXPECT_EQ(raster_size({0, 0, 10, 5}, options).height, 256);
  EXPECT_EQ(framed({0, 0, 10, 5}, options), (ViewBox{0, 0, 10, 5}));
  EXPECT_EQ(resolution({0, 0, 10, 5}, options), 51.2);
  options.size = RasterSize{301, 100};
  EXPECT_EQ(raster_size({0, 0, 10, 5}, options).width, 301);
  EXPECT_EQ(resolution({0, 0, 10, 5}, options), 20);
  const ViewBox box = framed({0, 0, 10, 5}, options);
  EXPECT_DOUBLE_EQ(box.x, -2.525);
  EXPECT_DOUBLE_EQ(box.width, 15.05);
  EXPECT_EQ(box.y, 0);
  EXPECT_EQ(box.height, 5);
  for (const RasterSize size : {RasterSize{1, 9}, RasterSize{9, 16385}, RasterSize{16384, 16384}}) {
    options.size = size;
    EXPECT_THROW(raster_size({0, 0, 1, 1}, options), std::invalid_argument);
  }
}

TEST(Over, MixesWithTheBackground) {
  const Raster raster{1, 2, {255, 0, 0, 0, 255, 0, 0, 51}};
  EXPECT_EQ(over(raster, std::nullopt).rgba, raster.rgba);
  EXPECT_EQ(over(raster, Colour{0, 0, 1}).rgba,
            (std::vector<std::uint8_t>{0, 0, 255, 255, 51, 0, 204, 255}));
}

TEST(RasterSize, IsEven) {
  const RasterSize size = raster_size({0, 0, 100, 33}, 401);
  EXPECT_EQ(size.width, 402);
  EXPECT_EQ(size.height, 132);
  EXPECT_EQ(raster_size({0, 0, 1e9, 1}, 64).height, 2);
  EXPECT_THROW(raster_size({0, 0, 1, 1}, 1), std::invalid_argument);
  EXPECT_THROW(raster_size({0, 0, 1, 1}, 20000), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::io
