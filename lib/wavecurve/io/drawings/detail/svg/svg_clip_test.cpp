#include "wavecurve/io/drawings/detail/svg/svg_clip.hpp"

#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"

namespace wavecurve::io {
namespace {

DrawingFile clipped(const std::string& shapes, const std::string& element,
                    const std::string& attributes = "") {
  return test::read("<clipPath id='c' " + attributes + ">" + shapes + "</clipPath>" + element);
}

double clipped_area(const std::string& shapes, const std::string& element,
                    const std::string& attributes = "") {
  const DrawingFile file = clipped(shapes, element, attributes);
  EXPECT_TRUE(file.warnings.empty()) << file.warnings.at(0);
  EXPECT_EQ(file.drawing.layers.size(), 1U);
  return std::abs(test::area_of(file.drawing.layers.at(0).subpaths));
}

const std::string window = "<rect width='24' height='24'/>";
const std::string circle = "<circle cx='50' cy='50' r='40'/>";
constexpr double disc = 1600 * std::numbers::pi;

TEST(SvgClip, WhatContainsWhatItClipsChangesNothing) {
  const auto stays = [](const std::string& shapes, const std::string& element) {
    const DrawingFile file = clipped(shapes, element);
    EXPECT_TRUE(file.warnings.empty()) << shapes << element;
    const std::string plain = element.substr(0, element.find(" clip-path")) +
                              element.substr(element.find("url(#c)'") + 8);
    const auto expected = test::read(plain).drawing.layers, layers = file.drawing.layers;
    ASSERT_EQ(layers.size(), expected.size());
    EXPECT_EQ(layers[0].paint, expected[0].paint);
    ASSERT_EQ(layers[0].subpaths.size(), expected[0].subpaths.size());
    for (std::size_t i = 0; i < layers[0].subpaths.size(); ++i) {
      EXPECT_EQ(layers[0].subpaths[i].segments.size(), expected[0].subpaths[i].segments.size());
    }
  };
  stays(window, "<g clip-path='url(#c)'><path d='M2 2h20v20H2z'/></g>");
  stays(window, "<path clip-path='url(#c)' d='M0 0h24v24H0z'/>");
  stays(circle, "<rect clip-path='url(#c)' x='30' y='30' width='40' height='40' rx='3'/>");
  stays(window,
        "<path clip-path='url(#c)' stroke='red' stroke-width='2' d='M2 2C9 2 22 9 22 22z'/>");
  // No convex shape, and several.
  stays("<path d='M50 0L79 90 2 35H98L21 90z'/>",
        "<ellipse clip-path='url(#c)' cx='50' cy='50' rx='4' ry='3'/>");
  stays("<rect width='12' height='24'/><rect x='12' width='12' height='24'/>",
        "<circle clip-path='url(#c)' cx='12' cy='12' r='9'/>");
}

TEST(SvgClip, AFillIsCut) {
  EXPECT_DOUBLE_EQ(clipped_area(window, "<path clip-path='url(#c)' d='M2 2h40v20H2z'/>"), 22 * 20);
  // Polygons within 1/8192 of the size of a circle.
  const double rounding = 2 * std::numbers::pi * 40 * 80 * std::numbers::sqrt2 / 8192;
  EXPECT_NEAR(clipped_area(circle, "<rect clip-path='url(#c)' width='50' height='100'/>"), disc / 2,
              rounding);
  EXPECT_NEAR(clipped_area("<rect width='50' height='50'/>",
                           "<circle clip-path='url(#c)' cx='50' cy='50' r='40'/>"),
              disc / 4, rounding);
  // A hole remains one, by either rule.
  const std::string frame = "d='M10 10h40v40H10zM20 20v20h20V20z'";
  for (const char* rule : {"nonzero", "evenodd"}) {
    EXPECT_DOUBLE_EQ(
        clipped_area("<rect width='30' height='100'/>",
                     fmt::format("<path clip-path='url(#c)' fill-rule='{}' {}/>", rule, frame)),
        20 * 40 - 10 * 20);
  }
}

TEST(SvgClip, AClipPathIsWhatItsShapesShowTogether) {
  const std::string all = "<rect clip-path='url(#c)' width='100' height='100'/>";
  EXPECT_DOUBLE_EQ(
      clipped_area("<rect width='30' height='10'/><rect x='20' width='30' height='10'/>", all),
      500);
  EXPECT_DOUBLE_EQ(
      clipped_area("<rect width='9' height='9' display='none'/><rect width='5' height='5'/>", all),
      25);
  const std::string two_squares = "d='M0 0h20v20H0zM5 5h10v10H5z'";
  EXPECT_DOUBLE_EQ(clipped_area("<path " + two_squares + "/>", all), 400);
  EXPECT_DOUBLE_EQ(clipped_area("<path clip-rule='evenodd' " + two_squares + "/>", all), 300);
  EXPECT_DOUBLE_EQ(clipped_area("<path " + two_squares + "/>", all, "clip-rule='evenodd'"), 300);
  EXPECT_DOUBLE_EQ(clipped_area("<use href='#r' x='10'/>",
                                "<defs><rect id='r' width='30' height='10'/></defs>" + all),
                   300);
  // Clip paths within clip paths.
  const std::string left = "<clipPath id='left'><rect width='20' height='100'/></clipPath>";
  EXPECT_DOUBLE_EQ(clipped_area(window, left + all, "clip-path='url(#left)'"), 20 * 24);
  EXPECT_DOUBLE_EQ(
      clipped_area("<rect width='24' height='24' clip-path='url(#left)'/>", left + all), 20 * 24);
}

TEST(SvgClip, ItLiesInTheCoordinatesOfTheElement) {
  EXPECT_DOUBLE_EQ(
      clipped_area(window,
                   "<g clip-path='url(#c)' transform='scale(2)'><path d='M2 2h99v20H2z'/></g>"),
      4 * 22 * 20);
  EXPECT_DOUBLE_EQ(clipped_area("<rect width='12' height='12' transform='scale(2)'/>",
                                "<path clip-path='url(#c)' d='M2 2h99v99H2z'/>"),
                   22 * 22);
  EXPECT_DOUBLE_EQ(clipped_area("<rect width='0.5' height='1'/>",
                                "<path clip-path='url(#c)' d='M20 20h40v20H20z'/>",
                                "clipPathUnits='objectBoundingBox'"),
                   20 * 20);
}

TEST(SvgClip, AStrokeIsCutAsWhatItPaints) {
  const auto file = clipped("<rect width='50' height='100'/>",
                            "<path clip-path='url(#c)' fill='none' stroke='red' stroke-width='6' "
                            "stroke-opacity='0.5' d='M10 20H90'/>");
  ASSERT_EQ(file.drawing.layers.size(), 1U);
  const Layer& layer = file.drawing.layers[0];
  EXPECT_NEAR(std::abs(test::area_of(layer.subpaths)), 40 * 6, 1e-9);
  EXPECT_FALSE(layer.paint.stroke.has_value());
  EXPECT_EQ(layer.paint.fill->red, 1);
  EXPECT_EQ(layer.paint.fill_opacity, 0.5);
  // The inner half of an outline, a common way to have one: fill and stroke are two layers.
  const auto inner =
      clipped("<rect x='10' y='10' width='40' height='40'/>",
              "<rect id='r' clip-path='url(#c)' x='10' y='10' width='40' height='40' "
              "fill='blue' stroke='red' stroke-width='4'/>");
  EXPECT_EQ(test::ids_of(inner.drawing), (std::vector<std::string>{"r", "r-stroke"}));
  EXPECT_NEAR(test::area_of(inner.drawing.layers[0].subpaths), 1600, 1e-9);
  EXPECT_NEAR(std::abs(test::area_of(inner.drawing.layers[1].subpaths)), 1600 - 36 * 36, 1e-9);
}

TEST(SvgClip, WhatLiesOutsideIsNotDrawn) {
  const auto file = clipped(window,
                            "<g clip-path='url(#c)'><rect id='out' x='50' width='9' height='9'/>"
                            "<rect id='in' width='9' height='9'/></g>");
  EXPECT_EQ(test::ids_of(file.drawing), std::vector<std::string>{"in"});
  EXPECT_NE(test::refusal([] {
              clipped("", "<path clip-path='url(#c)' d='M2 2h9v9z'/>");
            }).find("lies outside of its clip path"),
            std::string::npos);
}

TEST(SvgClip, WhatCannotBeClippedIsToldOf) {
  const auto told = [](const std::string& shapes, const std::string& element) {
    const DrawingFile file = clipped(shapes, element);
    EXPECT_EQ(file.drawing.layers.size(), 1U);
    return file.warnings.empty() ? std::string() : file.warnings.at(0);
  };
  const std::string path = "d='M2 2h90v20H2z'/>";
  EXPECT_EQ(told(window, "<path clip-path='url(#d)' " + path),
            "the clip-path 'url(#d)' clips nothing: no clipPath has the id 'd'");
  EXPECT_EQ(told(window, "<path clip-path='inset(1px)' " + path),
            "the clip-path 'inset(1px)' clips nothing: only url(#...) is supported");
  EXPECT_EQ(told("<text>a</text>", "<path clip-path='url(#c)' " + path),
            "the clip-path 'url(#c)' clips nothing: text in it is not supported");
  EXPECT_EQ(
      told("<rect width='9' height='9' clip-path='url(#c)'/>", "<path clip-path='url(#c)' " + path),
      "the clip-path 'url(#c)' clips nothing: it is used within itself");
  EXPECT_EQ(told(window, "<path clip-path='none' " + path), "");
  std::string comb = "M0 0";
  for (int i = 0; i < 3000; ++i) comb += fmt::format("L{} 100L{} 0", i / 30.0, i / 30.0 + 0.01);
  EXPECT_EQ(told(window, "<path clip-path='url(#c)' d='" + comb + "z'/>"),
            "the clip-path 'url(#c)' clips nothing: that would take too long");
}

TEST(SvgClip, ANestedViewportClips) {
  const std::string nested =
      "<svg x='10' y='10' width='20' height='20' {}><circle r='20' cx='20' cy='0'/></svg>";
  const auto cut = test::read(fmt::format(fmt::runtime(nested), ""));
  EXPECT_TRUE(cut.warnings.empty());
  EXPECT_NEAR(std::abs(test::area_of(cut.drawing.layers.at(0).subpaths)), 100 * std::numbers::pi,
              2 * std::numbers::pi * 20 * 20 * std::numbers::sqrt2 / 8192);
  const auto visible = test::read(fmt::format(fmt::runtime(nested), "overflow='visible'"));
  EXPECT_NEAR(test::area_of(visible.drawing.layers.at(0).subpaths), 400 * std::numbers::pi, 1);
}

}  // namespace
}  // namespace wavecurve::io
