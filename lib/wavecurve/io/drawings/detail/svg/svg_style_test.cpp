#include "wavecurve/io/drawings/detail/svg/svg_style.hpp"

#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"

namespace wavecurve::io {
namespace {

const std::string triangle = "d='M0 0L10 0L10 10Z'";

Paint paint(const std::string& attributes, const std::string& before = "",
            const std::string& after = "") {
  return test::only_layer(before + "<path " + triangle + " " + attributes + "/>" + after).paint;
}

Colour fill(const std::string& attributes, const std::string& before = "",
            const std::string& after = "") {
  const Paint found = paint(attributes, before, after);
  EXPECT_TRUE(found.fill.has_value()) << attributes;
  return found.fill.value_or(Colour{-1, -1, -1});
}

const Colour black{}, red{1, 0, 0}, lime{0, 1, 0}, blue{0, 0, 1};

TEST(Colour, EveryNotation) {
  EXPECT_EQ(fill("fill='red'"), red);
  EXPECT_EQ(fill("fill='RED'"), red);
  EXPECT_EQ(fill("fill='#f00'"), red);
  EXPECT_EQ(fill("fill='#FF0000'"), red);
  EXPECT_EQ(fill("fill='rgb(255, 0,0)'"), red);
  EXPECT_EQ(fill("fill='rgb(300,-5,0)'"), red);
  EXPECT_EQ(fill("fill='rgb(100%, 0%, 0%)'"), red);
  EXPECT_EQ(fill("fill='rgb(255 0 0)'"), red);
  EXPECT_EQ(fill("fill='hsl(120, 100%, 50%)'"), lime);
  EXPECT_EQ(fill("fill='rebeccapurple'"), black) << "not in the list of SVG 1.1";
  EXPECT_EQ(fill("fill='white\xc3\xa4'"), black) << "no name has an umlaut";
  EXPECT_EQ(fill("fill='cornflowerblue'"), (Colour{100 / 255.0, 149 / 255.0, 237 / 255.0}));
  EXPECT_EQ(fill("fill='#1a2B3c'"), (Colour{26 / 255.0, 43 / 255.0, 60 / 255.0}));
}

TEST(Colour, ItsOpacityIsThePaints) {
  EXPECT_DOUBLE_EQ(paint("fill='rgba(255,0,0,.25)'").fill_opacity, 0.25);
  EXPECT_DOUBLE_EQ(paint("fill='rgb(255 0 0 / 25%)'").fill_opacity, 0.25);
  EXPECT_DOUBLE_EQ(paint("fill='#ff000033'").fill_opacity, 0.2);
  EXPECT_DOUBLE_EQ(paint("fill='#f003' fill-opacity='.5'").fill_opacity, 0.1);
  EXPECT_DOUBLE_EQ(paint("fill='transparent'").fill_opacity, 0);
}

TEST(Style, CapsJoinsAndMiterLimit) {
  const Paint plain = paint("stroke='red'");
  EXPECT_EQ(plain.line_cap, LineCap::butt);
  EXPECT_EQ(plain.line_join, LineJoin::miter);
  EXPECT_EQ(plain.miter_limit, 4);
  const Paint given = paint("stroke='red' stroke-linejoin='bevel' stroke-miterlimit='2.5'",
                            "<g style='stroke-linecap:square'>", "</g>");
  EXPECT_EQ(given.line_cap, LineCap::square);
  EXPECT_EQ(given.line_join, LineJoin::bevel);
  EXPECT_EQ(given.miter_limit, 2.5);
  const auto warnings = test::read("<path " + triangle +
                                   " stroke='red' stroke-linecap='flat' stroke-linejoin='arcs'"
                                   " stroke-miterlimit='0.5'/>")
                            .warnings;
  EXPECT_EQ(warnings, (std::vector<std::string>{"the stroke-linecap 'flat' is not supported",
                                                "the stroke-linejoin 'arcs' is not supported",
                                                "the stroke-miterlimit '0.5' is not supported"}));
}

TEST(Style, AStrokeMayKeepItsWidth) {
  const std::string scaled = "stroke='red' stroke-width='2' transform='scale(10)'";
  EXPECT_DOUBLE_EQ(paint(scaled).stroke_width, 20);
  EXPECT_DOUBLE_EQ(paint(scaled + " vector-effect='non-scaling-stroke'").stroke_width, 2);
  EXPECT_DOUBLE_EQ(paint(scaled, "<g vector-effect='non-scaling-stroke'>", "</g>").stroke_width, 20)
      << "it is not inherited";
}

TEST(Style, PaintOrderMayPutTheStrokeFirst) {
  const auto first = [](const std::string& order) {
    const Drawing drawing =
        test::read("<path id='p' " + triangle + " stroke='red' paint-order='" + order + "'/>")
            .drawing;
    return drawing.layers.size() == 1 ? "both" : drawing.layers[0].id + ", " + drawing.layers[1].id;
  };
  EXPECT_EQ(first("normal"), "both");
  EXPECT_EQ(first("fill stroke"), "both");
  EXPECT_EQ(first("markers"), "both");
  EXPECT_EQ(first("stroke"), "p-stroke, p");
  EXPECT_EQ(first("markers stroke"), "p-stroke, p");
}

TEST(Style, TheOpacityOfAGroupOfSeveralIsWarnedOf) {
  const std::string one = "<path " + triangle + "/>";
  EXPECT_TRUE(test::read("<g opacity='.5'>" + one + "</g>" + one).warnings.empty());
  EXPECT_EQ(test::read("<g opacity='.5'>" + one + one + "</g>").warnings,
            std::vector<std::string>{"the opacity of a group is given to each of its shapes"});
}

TEST(Style, FillIsBlackAndStrokeNoneUnlessGiven) {
  const Paint found = paint("");
  EXPECT_EQ(found, (Paint{black, {}, 1, 1, 1, FillRule::nonzero}));
  EXPECT_EQ(paint("fill='none' stroke='blue'").fill, std::nullopt);
  EXPECT_EQ(paint("fill='none' stroke='blue'").stroke, blue);
  EXPECT_EQ(paint("fill-rule='evenodd'").fill_rule, FillRule::evenodd);
}

TEST(Style, GroupsPassOnWhatIsInherited) {
  const std::string group = "<g fill='red' stroke='blue' stroke-width='3' fill-rule='evenodd'>";
  const Paint found = paint("", group + "<g>", "</g></g>");
  EXPECT_EQ(found.fill, red);
  EXPECT_EQ(found.stroke, blue);
  EXPECT_EQ(found.stroke_width, 3);
  EXPECT_EQ(found.fill_rule, FillRule::evenodd);
  EXPECT_EQ(fill("fill='lime'", group, "</g>"), lime);
  EXPECT_EQ(fill("fill='inherit'", group, "</g>"), red);
}

TEST(Style, OpacityOfGroupsMultiplies) {
  const Paint found = paint("opacity='.5' fill-opacity='.5' stroke='red' stroke-opacity='.25'",
                            "<g opacity='.5'><g opacity='50%'>", "</g></g>");
  EXPECT_DOUBLE_EQ(found.fill_opacity, 1.0 / 16);
  EXPECT_DOUBLE_EQ(found.stroke_opacity, 1.0 / 32);
  EXPECT_DOUBLE_EQ(paint("opacity='7'").fill_opacity, 1);
}

TEST(Style, CurrentColourIsThatOfTheElementItself) {
  EXPECT_EQ(fill("fill='currentColor'", "<g color='red'>", "</g>"), red);
  EXPECT_EQ(fill("color='blue'", "<g color='red' fill='currentColor'>", "</g>"), blue);
}

TEST(Style, SheetsOverruleAttributesAndAreOverruledByTheStyleOfAnElement) {
  const auto sheet = [](const std::string& css) { return "<style>" + css + "</style>"; };
  EXPECT_EQ(fill("fill='red'", sheet("path{fill:blue}")), blue);
  EXPECT_EQ(fill("fill='red' style='fill : lime ;'", sheet("path{fill:blue}")), lime);
  EXPECT_EQ(fill("style='fill:lime'", sheet("path{fill:blue ! important}")), blue);
  EXPECT_EQ(fill("style='fill:lime!important'", sheet("path{fill:blue!important}")), lime);
  EXPECT_EQ(fill("class='a b'", sheet(".b{fill:blue} path{fill:red}")), blue);
  EXPECT_EQ(fill("class='a' id='i'", sheet("#i{fill:blue} .a.a{fill:red} path.a{fill:red}")), blue);
  EXPECT_EQ(fill("class='a'", sheet(".a{fill:red} .a{fill:blue}")), blue);
  EXPECT_EQ(fill("class='a'", sheet(".b, .a{fill:blue} *{fill:red}")), blue);
  EXPECT_EQ(fill("class='A'", sheet(".a{fill:red}")), black) << "case counts";
  EXPECT_EQ(fill("class='ab'", sheet(".a{fill:red}")), black);
  EXPECT_EQ(fill("", sheet("/* path{fill:red} */ path{/**/fill:blue}")), blue);
  EXPECT_EQ(fill("", "<style><![CDATA[path{fill:blue}]]></style>"), blue);
  EXPECT_EQ(fill("", "<defs>" + sheet("path{fill:blue}") + "</defs>"), blue);
}

TEST(Style, SelectorsOfDescendantsAndChildren) {
  const auto with = [](const std::string& selector) {
    return fill("class='p'", "<style>" + selector + "{fill:red}</style><g id='a'><g class='b'><g>",
                "</g></g></g>");
  };
  EXPECT_EQ(with("#a path"), red);
  EXPECT_EQ(with("svg g .p"), red);
  EXPECT_EQ(with("#a > .b > g > path"), red);
  EXPECT_EQ(with("g g g path"), red);
  EXPECT_EQ(with("g g g g path"), black);
  EXPECT_EQ(with(".b > path"), black);
  EXPECT_EQ(with("path #a"), black);
  EXPECT_EQ(with("#a > g path"), red);
}

TEST(Style, WhatTheSheetCannotSayIsNamedOnce) {
  const DrawingFile file = test::read(
      "<style>@import url(x.css); @media print { path { fill: red } } path:hover{fill:red} "
      "path:hover{fill:red} path{fill:blue; font-family: x}</style><path " +
      triangle + "/>");
  EXPECT_EQ(file.drawing.layers.at(0).paint.fill, blue);
  EXPECT_EQ(file.warnings,
            (std::vector<std::string>{"the CSS rule @import is not supported",
                                      "the CSS rule @media is not supported",
                                      "the CSS selector 'path:hover' is not supported"}));
}

TEST(Style, GradientsBecomeTheirMeanColour) {
  const std::string gradients =
      "<linearGradient id='l'><stop stop-color='red'/><stop style='stop-color:#00f' "
      "stop-opacity='.5'/></linearGradient><radialGradient id='r' xlink:href='#l'/>"
      "<pattern id='p'/><linearGradient id='x' href='#y'/><linearGradient id='y' href='#x'/>";
  for (const std::string id : {"l", "r"}) {
    const DrawingFile file =
        test::read(gradients + "<path " + triangle + " fill='url(#" + id + ") lime'/>");
    const Paint found = file.drawing.layers.at(0).paint;
    EXPECT_EQ(found.fill, (Colour{0.5, 0, 0.5}));
    EXPECT_DOUBLE_EQ(found.fill_opacity, 0.75);
    EXPECT_EQ(file.warnings,
              std::vector<std::string>{"the gradient '" + id + "' is replaced by its mean colour"});
  }
  EXPECT_EQ(fill("fill='url(#p) lime'", gradients), lime);
  EXPECT_EQ(fill("fill='url(#x) lime'", gradients), lime);
  EXPECT_EQ(paint("fill='url(#none)' stroke='red'", gradients).fill, std::nullopt);
}

TEST(Style, StrokesScaleWithTheirOutline) {
  EXPECT_DOUBLE_EQ(
      paint("stroke='red' stroke-width='2'", "<g transform='scale(3)'>", "</g>").stroke_width, 6);
  EXPECT_DOUBLE_EQ(paint("stroke='red' stroke-width='10%'").stroke_width, 10);
  EXPECT_EQ(paint("stroke='red' stroke-width='0'").stroke, std::nullopt);
  const DrawingFile file =
      test::read("<path stroke='red' transform='scale(1 4)' " + triangle + "/>");
  EXPECT_DOUBLE_EQ(file.drawing.layers.at(0).paint.stroke_width, 2);
  EXPECT_EQ(file.warnings.size(), 1U);
}

TEST(Style, HiddenThingsAreNotDrawn) {
  EXPECT_EQ(fill("fill='red'", "<path " + triangle + " display='none'/>"), red);
  EXPECT_EQ(fill("fill='red'", "<g style='display:none'><path " + triangle + "/></g>"), red);
  EXPECT_EQ(fill("fill='red'", "<path " + triangle + " visibility='hidden'/>"), red);
  EXPECT_EQ(fill("fill='red'", "<path " + triangle + " fill='none'/>"), red);
  EXPECT_EQ(fill("fill='red' visibility='visible'", "<g visibility='hidden'>", "</g>"), red);
}

TEST(Style, WhatIsNotSupportedIsNamedOnce) {
  const DrawingFile file = test::read(
      "<text>a</text><text>b</text><image/><g filter='url(#f)' mask='url(#m)'><path " + triangle +
      " clip-path='url(#c)' stroke-dasharray='1 2' fill='blurple' opacity='x'><animate/></path>"
      "</g><title>t</title><desc/><metadata/><foreign xmlns='urn:x'/>");
  EXPECT_EQ(
      file.warnings,
      (std::vector<std::string>{
          "text is not supported: convert it to paths", "images are not supported",
          "the property mask is not supported", "the property filter is not supported",
          "the fill 'blurple' is not supported", "the opacity 'x' is not supported",
          "the property stroke-dasharray is not supported", "the element animate is not supported",
          "the clip-path 'url(#c)' clips nothing: no clipPath has the id 'c'"}));
}

TEST(Style, SelectorsOfEveryKind) {
  const auto filled = [](const std::string& selector) {
    const DrawingFile file =
        test::read("<style>" + selector + "{fill:red}</style><g><path id='first' " + triangle +
                   "/><path id='icon-a' data-x='one two' lang='de-at' " + triangle + "/></g>");
    EXPECT_EQ(file.warnings, std::vector<std::string>{}) << selector;
    std::string ids;
    for (const Layer& layer : file.drawing.layers) {
      if (layer.paint.fill == red) ids += layer.id + " ";
    }
    return ids;
  };
  EXPECT_EQ(filled("path:first-child"), "first ");
  EXPECT_EQ(filled("path:last-child"), "icon-a ");
  EXPECT_EQ(filled("path:not(:first-child)"), "icon-a ");
  EXPECT_EQ(filled("path:not(#icon-a)"), "first ");
  EXPECT_EQ(filled("[data-x]"), "icon-a ");
  EXPECT_EQ(filled("[id=first]"), "first ");
  EXPECT_EQ(filled("path[id=\"first\"]"), "first ");
  EXPECT_EQ(filled("[id^='icon']"), "icon-a ");
  EXPECT_EQ(filled("[id$='t']"), "first ");
  EXPECT_EQ(filled("[id*='con']"), "icon-a ");
  EXPECT_EQ(filled("[data-x~='two']"), "icon-a ");
  EXPECT_EQ(filled("[lang|=de]"), "icon-a ");
  EXPECT_EQ(filled("[id^='']"), "");
  EXPECT_EQ(filled("g > [id=first], [data-x='one two']"), "first icon-a ");
  // :not() counts as what it holds: an attribute outdoes a name.
  EXPECT_EQ(filled("path:not([data-x])"), "first ");
}

TEST(Style, DeclarationsMayHoldComments) {
  EXPECT_EQ(fill("style='/* a; fill:blue */fill:/* b */red'"), red);
  EXPECT_EQ(fill("style='background:url(data:image/png;base64,a;fill:lime);fill:red'"), red);
}

TEST(Style, VariablesAndMediaAreNamed) {
  const DrawingFile file = test::read("<style>@media print{path{fill:lime}}</style><path " +
                                      triangle + " style='fill:var(--c)'/>");
  EXPECT_EQ(file.drawing.layers.at(0).paint.fill, black);
  EXPECT_EQ(file.warnings, (std::vector<std::string>{"the CSS rule @media is not supported",
                                                     "the fill 'var(--c)' is not supported"}));
}

TEST(Style, GeometryMayBeGivenByCss) {
  const auto box = [](const std::string& body) {
    const auto size = test::box_of(test::only_layer(body).subpaths).sizes().eval();
    return std::pair(std::round(size.x()), std::round(size.y()));
  };
  EXPECT_EQ(box("<style>circle{r:20px;cx:50px}</style><circle r='1'/>"), std::pair(40.0, 40.0));
  EXPECT_EQ(box("<style>rect{width:30px;x:5px}</style><rect height='10'/>"), std::pair(30.0, 10.0));
  EXPECT_EQ(box("<path style='d:path(\"M0 0H8V6z\")'/>"), std::pair(8.0, 6.0));
}

}  // namespace
}  // namespace wavecurve::io
