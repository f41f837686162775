#include "wavecurve/io/drawings/detail/svg/read_svg.hpp"

#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"

namespace wavecurve::io {
namespace {

using Eigen::Vector2d;
using test::box_of;
using test::layer_of;
using test::read;

const std::string unit_square = "<rect width='1' height='1'/>";

void expect_box(const std::vector<Subpath>& subpaths, double x0, double y0, double x1, double y1) {
  const auto box = box_of(subpaths);
  test::expect_near(box.min(), x0, y0, 1e-12);
  test::expect_near(box.max(), x1, y1, 1e-12);
}

TEST(ReadSvg, ViewBoxIsTheFilesOrItsSizeOrThatOfTheOutlines) {
  const auto view_box = [](const std::string& root) {
    return read_svg("<svg " + root + "><rect x='5' y='6' width='7' height='8'/></svg>")
        .drawing.view_box;
  };
  EXPECT_EQ(view_box("viewBox='-1,-2 30 40' width='60' height='80'"), (ViewBox{-1, -2, 30, 40}));
  EXPECT_EQ(view_box("width='60px' height='1in'"), (ViewBox{0, 0, 60, 96}));
  EXPECT_EQ(view_box("width='100%' height='100%'"), (ViewBox{5, 6, 7, 8}));
  EXPECT_EQ(view_box(""), (ViewBox{5, 6, 7, 8}));
  const auto stroke = read_svg("<svg><path stroke='red' stroke-width='2' d='M0 5H10'/></svg>");
  EXPECT_EQ(stroke.drawing.view_box, (ViewBox{-1, 4, 12, 2}));
}

TEST(ReadSvg, TransformsOfNestedGroupsMultiply) {
  const auto layer = test::only_layer(
      "<g transform='translate(10 20)'><g transform='scale(2)'>"
      "<rect x='1' width='1' height='1' transform='scale(1 3)'/>"
      "</g></g>");
  expect_box(layer.subpaths, 12, 20, 14, 26);
}

TEST(ReadSvg, NestedSvgFitsItsViewBox) {
  const auto box = [](const std::string& attributes, double x0, double y0, double x1, double y1) {
    SCOPED_TRACE(attributes);
    expect_box(test::only_layer(
                   "<svg x='10' y='20' width='40' height='20' viewBox='1 1 10 10' " + attributes +
                   " overflow='visible'><rect x='1' y='1' width='10' height='10'/></svg>")
                   .subpaths,
               x0, y0, x1, y1);
  };
  box("", 20, 20, 40, 40);
  box("preserveAspectRatio='xMinYMid'", 10, 20, 30, 40);
  box("preserveAspectRatio='xMaxYMid meet'", 30, 20, 50, 40);
  box("preserveAspectRatio='xMidYMin slice'", 10, 20, 50, 60);
  box("preserveAspectRatio='xMidYMax slice'", 10, 0, 50, 40);
  box("preserveAspectRatio='none'", 10, 20, 50, 40);
}

TEST(ReadSvg, PercentagesReferToTheNearestViewBox) {
  const auto layer = test::only_layer(
      "<svg x='10%' width='50%' height='50%' viewBox='0 0 4 4'>"
      "<rect width='50%' height='25%'/></svg>");
  expect_box(layer.subpaths, 10, 0, 35, 12.5);
}

TEST(ReadSvg, LayersAreInPaintingOrderWithUniqueIds) {
  const auto file = read(
      "<rect id='a' width='1' height='1'/><g id='g'><path d='M0 0L1 1 0 2z'/><circle r='1'/></g>"
      "<path d='M0 0L1 1 0 2z'/><rect id='a' width='2' height='1'/><rect id='path-3' width='1' "
      "height='1'/><path d='M0 0L1 1 0 2z'/><rect id='a' width='3' height='1'/>");
  EXPECT_EQ(test::ids_of(file.drawing),
            (std::vector<std::string>{"a", "path-1", "circle-1", "path-2", "a-2", "path-3",
                                      "path-3-2", "a-3"}));
}

TEST(ReadSvg, HolesAreFurtherSubpaths) {
  const auto layer = test::only_layer("<path fill-rule='evenodd' d='M0 0H9V9H0ZM3 3V6H6V3Z'/>");
  ASSERT_EQ(layer.subpaths.size(), 2U);
  EXPECT_DOUBLE_EQ(test::area_of(layer.subpaths), 72);
}

TEST(ReadSvg, AFillClosesAnOpenSubpathAStrokeDoesNot) {
  const auto filled = test::only_layer("<path d='M0 0L10 0L10 10'/>");
  EXPECT_TRUE(filled.subpaths.at(0).closed);
  EXPECT_EQ(filled.subpaths[0].segments.size(), 3U);
  EXPECT_DOUBLE_EQ(test::area_of(filled.subpaths), 50);
  const auto both = read("<path id='p' d='M0 0L10 0L10 10' stroke='red'/>").drawing;
  EXPECT_EQ(test::ids_of(both), (std::vector<std::string>{"p", "p-stroke"}));
  EXPECT_FALSE(layer_of(both, "p").paint.stroke);
  EXPECT_TRUE(layer_of(both, "p").subpaths.at(0).closed);
  EXPECT_FALSE(layer_of(both, "p-stroke").paint.fill);
  EXPECT_FALSE(layer_of(both, "p-stroke").subpaths.at(0).closed);
  const auto closed = test::only_layer("<path d='M0 0L10 0L10 10z' stroke='red'/>");
  EXPECT_TRUE(closed.paint.fill && closed.paint.stroke);
}

TEST(ReadSvg, EndsThatMeetButForRoundingMeet) {
  const auto path = test::path_of("M0.1 0.2l0.1 0.2l0.1 0.2l-.2 -.4");
  EXPECT_TRUE(path.at(0).closed);
  EXPECT_EQ(path[0].segments.size(), 3U);
  const auto ended = test::path_of("M0.1 0.2l0.1 0.2l0.1 0.2l-.2 -.4z");
  EXPECT_EQ(ended.at(0).segments.size(), 3U);
  EXPECT_EQ(ended[0].segments.back().control.col(1), Vector2d(0.1, 0.2));
  EXPECT_FALSE(test::path_of("M0 0L10 0L10 10L0 1e-6").at(0).closed);
}

TEST(ReadSvg, SegmentsWithoutLengthAreLeftOut) {
  EXPECT_EQ(test::path_of("M1 1L1 1L5 5L5 5C5 5 5 5 5 5L9 1").at(0).segments.size(), 2U);
}

TEST(ReadSvg, UseDrawsCopiesInTheStyleAndPlaceOfTheUse) {
  const auto drawing =
      read(
          "<defs><rect id='r' width='2' height='2'/><g id='g' fill='blue'><use "
          "href='#r'/></g></defs>"
          "<use id='left' xlink:href='#r' x='10' y='20' fill='red'/><use href='#g' "
          "transform='scale(3)'/><use href='#r' x='10%'/>")
          .drawing;
  EXPECT_EQ(test::ids_of(drawing), (std::vector<std::string>{"left", "r", "r-2"}));
  expect_box(layer_of(drawing, "left").subpaths, 10, 20, 12, 22);
  EXPECT_EQ(layer_of(drawing, "left").paint.fill, (Colour{1, 0, 0}));
  expect_box(layer_of(drawing, "r").subpaths, 0, 0, 6, 6);
  EXPECT_EQ(layer_of(drawing, "r").paint.fill, (Colour{0, 0, 1}));
  expect_box(layer_of(drawing, "r-2").subpaths, 10, 0, 12, 2);
}

TEST(ReadSvg, SymbolsAreDrawnWhereTheyAreUsedOnly) {
  const auto drawing = read(
                           "<symbol id='s' viewBox='0 0 4 4' fill='red'><rect id='r' width='4' "
                           "height='4'/></symbol><use href='#s' x='10' width='8' height='16'/>")
                           .drawing;
  EXPECT_EQ(test::ids_of(drawing), std::vector<std::string>{"r"});
  expect_box(layer_of(drawing, "r").subpaths, 10, 4, 18, 12);
  EXPECT_EQ(layer_of(drawing, "r").paint.fill, (Colour{1, 0, 0}));
}

TEST(ReadSvg, SwitchDrawsWhatAViewerWithoutLanguageWould) {
  const auto ids = [](const std::string& body) {
    return test::ids_of(read("<switch>" + body + "</switch>").drawing);
  };
  using Ids = std::vector<std::string>;
  EXPECT_EQ(ids("<circle r='1'/>" + unit_square), Ids{"circle-1"});
  EXPECT_EQ(ids("<foreignObject requiredExtensions='x'/><g><circle r='1'/></g>"), Ids{"circle-1"});
  EXPECT_EQ(ids("<g systemLanguage='de'>" + unit_square + "</g><g systemLanguage='en'>" +
                unit_square + "</g><circle r='1'/>"),
            Ids{"circle-1"});
  EXPECT_EQ(
      test::ids_of(read("<g systemLanguage='de'>" + unit_square + "</g><circle r='1'/>").drawing),
      Ids{"circle-1"});
}

TEST(ReadSvg, TheElementKeepsItsIdAndCopiesGetANumber) {
  EXPECT_EQ(
      test::ids_of(read("<use href='#r' x='50'/><rect id='r' width='3' height='3'/><use id='u' "
                        "href='#r'/><rect id='s' width='3' height='3'/>")
                       .drawing),
      (std::vector<std::string>{"r-2", "r", "u", "s"}));
}

TEST(ReadSvg, InkscapesLabelsNameLayers) {
  const DrawingFile file = read_svg(
      "<svg xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape'>"
      "<g id='layer1' inkscape:label='Nose' inkscape:groupmode='layer'><path id='path12' d='M0 0H9V9z'/>"
      "<path id='tip' d='M0 0H9V9z'/></g><path id='path7' inkscape:label='Left ear' d='M0 0H9V9z'/></svg>");
  EXPECT_EQ(test::ids_of(file.drawing), (std::vector<std::string>{"Nose", "tip", "Left ear"}));
}

TEST(ReadSvg, OneElementOfASprite) {
  const std::string sprite =
      "<svg viewBox='0 0 99 99'><symbol id='a' viewBox='0 0 24 24'><circle r='5'/></symbol>"
      "<g transform='scale(9)'><g id='b' transform='scale(2)'><rect id='r' width='3' height='4'/></g></g>"
      "<view id='v' viewBox='0 0 8 8'/></svg>";
  EXPECT_EQ(read_svg(sprite, "a").drawing.view_box, (ViewBox{0, 0, 24, 24}));
  EXPECT_EQ(test::ids_of(read_svg(sprite, "a").drawing), std::vector<std::string>{"circle-1"});
  const Drawing group = read_svg(sprite, "b").drawing;
  EXPECT_EQ(test::ids_of(group), std::vector<std::string>{"r"});
  EXPECT_EQ(group.view_box, (ViewBox{0, 0, 6, 8}));
  EXPECT_EQ(read_svg(sprite, "v").drawing.view_box, (ViewBox{0, 0, 8, 8}));
  EXPECT_EQ(test::refusal([&] { read_svg(sprite, "c"); }), "no element has the id 'c'");
  EXPECT_EQ(test::refusal([] { read("<symbol id='s'><circle r='5'/></symbol>"); }),
            "nothing is painted: symbols only; FILE#s is one");
}

TEST(ReadSvg, PercentagesWithoutAWindowAreToldOf) {
  const DrawingFile file =
      read_svg("<svg width='100%' height='100%'><rect x='10%' width='80%' height='80%'/></svg>");
  EXPECT_EQ(file.drawing.view_box, (ViewBox{0, 0, 300, 150}));
  expect_box(file.drawing.layers.at(0).subpaths, 30, 0, 270, 120);
  EXPECT_EQ(file.warnings,
            std::vector<std::string>{"the drawing has no size; percentages are taken of "
                                     "300 by 150"});
}

TEST(ReadSvg, AUseOfNothingIsNamed) {
  const auto file = read("<use href='#none'/><use/>" + unit_square);
  EXPECT_EQ(file.warnings, (std::vector<std::string>{"use of '#none', which is not in the file",
                                                     "use of '', which is not in the file"}));
}

TEST(ReadSvg, AShapeWithoutLengthIsSkipped) {
  const auto file = read("<path id='dot' d='M5 5L5 5z'/><circle r='0'/>" + unit_square);
  EXPECT_EQ(file.drawing.layers.size(), 1U);
  EXPECT_EQ(file.warnings, (std::vector<std::string>{"line 1: dot has no length",
                                                     "line 1: circle-1 has no length"}));
}

TEST(ReadSvg, ALineWithoutLengthIsADotWhereItHasCaps) {
  const std::string stroke = "stroke='red' stroke-width='20' stroke-linecap='";
  for (const std::string data : {"M20 20z", "M20 20h0", "M20 20L20 20z"}) {
    const Layer dot = test::only_layer("<path d='" + data + "' " + stroke + "round'/>");
    ASSERT_EQ(dot.subpaths.size(), 1U) << data;
    EXPECT_FALSE(dot.subpaths[0].closed);
    EXPECT_FALSE(dot.paint.fill);
    EXPECT_NEAR(dot.subpaths[0].segments[0].control(0, 1), 20, 0.01);
    EXPECT_THROW(test::read("<path d='" + data + "' " + stroke + "butt'/>"), std::invalid_argument);
  }
  EXPECT_THROW(test::read("<path d='M20 20' " + stroke + "round'/>"), std::invalid_argument);
  EXPECT_EQ(test::path_of("M0 0L9 0L9 9zz").size(), 1U);
}

}  // namespace
}  // namespace wavecurve::io
