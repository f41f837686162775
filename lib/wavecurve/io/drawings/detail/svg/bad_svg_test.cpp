// What is broken, hostile or empty is refused in one line, whatever its size.
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"
#include "wavecurve/io/drawings/detail/svg/style_sheet.hpp"
#include "wavecurve/io/drawings/detail/svg/warnings.hpp"
#include "wavecurve/io/drawings/detail/svg/xml_element.hpp"

namespace wavecurve::io {
namespace {

std::string refused(const std::string& text) {
  const std::string message = test::refusal([&] { read_svg(text); });
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  return message;
}

std::string refused_body(const std::string& body) {
  return refused("<svg viewBox='0 0 9 9'>\n" + body + "</svg>");
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

TEST(BadSvg, WhatIsNoXmlNamesTheLine) {
  EXPECT_EQ(refused(""), "not XML: it is empty");
  EXPECT_TRUE(refused("hello").starts_with("line 1: not XML: "));
  EXPECT_TRUE(refused(" \n ").starts_with("line 2: not XML: "));
  EXPECT_TRUE(refused("<svg>\n<g></svg>").starts_with("line 2: not XML: "));
  EXPECT_TRUE(refused(std::string("<svg>\0</svg>", 12)).find("not XML") != std::string::npos);
  EXPECT_TRUE(refused("\xff\xfe\x01").find("not XML") != std::string::npos);
  EXPECT_EQ(refused("<html/>"), "line 1: the root element is html, not svg");
}

TEST(BadSvg, NothingToDraw) {
  EXPECT_EQ(refused_body("<g/>"), "nothing is painted: no path or shape");
  EXPECT_EQ(refused_body("<text>a</text>"),
            "nothing is painted: text is not supported: convert it to paths");
  EXPECT_EQ(refused_body("<image/>"), "nothing is painted: images are not supported");
  EXPECT_EQ(refused_body("<path id='p' d='M5 5'/>"), "nothing is painted: line 2: p has no length");
  EXPECT_EQ(refused_body("<path d='M5 5L5 5C5 5 5 5 5 5Z'/>"),
            "nothing is painted: line 2: path-1 has no length");
  EXPECT_EQ(refused_body("<path fill='none' d='M5 5L6 7 8 9'/>"),
            "nothing is painted: line 2: path-1 has neither fill nor stroke");
  EXPECT_EQ(refused_body("<line x2='5'/>"),
            "nothing is painted: line 2: line-1 is a line without stroke");
}

TEST(BadSvg, WhatIsBrokenIsNamedWhereNothingElseIsThere) {
  EXPECT_EQ(refused_body("<path id='p' d='M0 0L1e308 1 2 2'/>"),
            "nothing is painted: line 2: path 'p': coordinate 1e+308 is not within +-1e+09");
  EXPECT_EQ(refused_body("<path id='p' d='M0 0LNaN 1'/>"),
            "nothing is painted: line 2: path 'p': no path data after 4 characters, at 'LNaN 1'");
  EXPECT_EQ(refused_body("<path d='M0 0L1e999 1'/>"),
            "nothing is painted: line 2: path: no path data after 4 characters, at 'L1e999 1'");
  EXPECT_EQ(
      refused_body("<path d='M0 0A1e308 1e308 0 1 1 3 3'/>"),
      "nothing is painted: line 2: path: an arc of radii 1e+308 and 1e+308 to (3, 3) has no centre");
  EXPECT_EQ(refused_body("<g transform='scale(1e200)'><path d='M0 0L1 1 2 0'/></g>"),
            "nothing is painted: line 2: path: coordinate 1e+200 is not within +-1e+09");
  EXPECT_EQ(refused_body("<g transform='turn(3)'/>"),
            "nothing is painted: line 2: g: no transformation after 0 characters, at 'turn(3)'");
  EXPECT_EQ(
      refused("<svg viewBox='0 0 -1 5'/>"),
      "nothing is painted: line 1: svg: viewBox '0 0 -1 5' is not four numbers up to 1e9, the last two positive");
}

TEST(BadSvg, OneBrokenElementIsNamedAndTheRestIsDrawn) {
  const auto expect_warning = [](const std::string& element, const std::string& warning,
                                 std::size_t layers) {
    const DrawingFile file = test::read("\n" + element + "<rect id='sound' width='1' height='1'/>");
    EXPECT_EQ(file.warnings, std::vector<std::string>{"line 2: " + warning}) << element;
    EXPECT_EQ(file.drawing.layers.size(), layers) << element;
    EXPECT_EQ(file.drawing.layers.back().id, "sound");
  };
  const std::string part = "; what is sound of it is drawn", none = "; it is skipped";
  expect_warning("<path id='p' d='M10 10L90 10L90 90L-nan -nanL10 90Z'/>",
                 "path 'p': no path data after 18 characters, at 'L-nan -nanL10 90'" + part, 2);
  expect_warning("<path d='M10 10 L90 20 50 90 30'/>",
                 "path: no path data after 20 characters, at '30'" + part, 2);
  expect_warning("<path d='L5 5'/>", "path: no path data after 0 characters, at 'L5 5'" + none, 1);
  expect_warning("<polygon points='10,10 90,10 50,90 7'/>",
                 "polygon: no list of points after 18 characters, at '7'" + part, 2);
  expect_warning("<circle r='-5'/>", "circle: r -5 is below 0" + none, 1);
  expect_warning("<rect width='-5' height='5'/>", "rect: width -5 is below 0" + none, 1);
  expect_warning("<rect width='5' height='5' rx='-1'/>", "rect: rx -1 is below 0" + part, 2);
  expect_warning("<rect width='10vw' height='10'/>",
                 "rect: width '10vw' is no finite length" + none, 1);
  expect_warning("<rect width='calc(1px + 2px)' height='10'/>",
                 "rect: width 'calc(1px + 2px)' is no finite length" + none, 1);
  expect_warning("<path d='M0 0L1e308 1 2 2'/>",
                 "path: coordinate 1e+308 is not within +-1e+09" + none, 1);
  expect_warning("<svg viewBox='0 0 x'><path d='M0 0H9V9z'/></svg>",
                 "svg: viewBox '0 0 x' is not four numbers up to 1e9, the last two positive; it is "
                 "left out",
                 2);
  expect_warning("<use id='u' href='#u'/>", "use 'u': uses '#u' within itself" + none, 1);
}

TEST(BadSvg, EntitiesAreBounded) {
  std::string laughs = "<!DOCTYPE svg [\n<!ENTITY a0 'ha'>";
  for (int i = 1; i < 10; ++i) {
    laughs += "<!ENTITY a" + std::to_string(i) + " '" +
              repeated("&a" + std::to_string(i - 1) + ";", 10) + "'>";
  }
  EXPECT_EQ(refused(laughs + "]>\n<svg><path d='&a9;'/></svg>"),
            "line 3: entities stand for more than 4194304 references and characters");
  EXPECT_EQ(refused("<!DOCTYPE svg [<!ENTITY a SYSTEM 'file:///etc/passwd'>]><svg>&a;</svg>"),
            "line 1: declares the entity a, which lies elsewhere and is not read");
  EXPECT_EQ(refused("<!DOCTYPE svg [<!ENTITY % a 'b'>]><svg/>"),
            "line 1: declares the parameter entity a; only general ones are read");
  EXPECT_TRUE(refused("<svg>&a;</svg>").starts_with("line 1: not XML: "));
}

TEST(BadSvg, EntitiesAndAttributesOfTheDocumentTypeAreRead) {
  const DrawingFile file = read_svg(
      "<!DOCTYPE svg [<!ENTITY ns 'http://www.w3.org/2000/svg'><!ENTITY st 'fill:#ff0000;'>\n"
      "<!ATTLIST rect width CDATA '7'>]>\n<svg xmlns='&ns;'><rect style='&st;' height='5'/></svg>");
  EXPECT_EQ(file.warnings, std::vector<std::string>{});
  EXPECT_EQ(file.drawing.layers.at(0).paint.fill, (Colour{1, 0, 0}));
  EXPECT_EQ(file.drawing.view_box, (ViewBox{0, 0, 7, 5}));
  const std::string many = repeated("<g/>", 500'001);
  EXPECT_EQ(refused("<!DOCTYPE svg [<!ATTLIST g a CDATA '1' b CDATA '2'>]><svg>" + many + "</svg>"),
            "line 1: more than 1000000 attributes that the document type gives");
}

TEST(BadSvg, ADocumentTypeElsewhereIsNotFetched) {
  // A fetch from this port, or of this file, would be refused, slow, or both.
  const std::string path = "<svg><path d='M0 0L1 1 2 0'/></svg>";
  for (const std::string where : {"http://127.0.0.1:1/svg.dtd", "file:///no/such.dtd"}) {
    EXPECT_EQ(read_svg("<!DOCTYPE svg SYSTEM '" + where + "'>" + path).drawing.layers.size(), 1U);
  }
}

TEST(BadSvg, RecursionIsLeftOut) {
  const std::string nothing = "nothing is painted: ";
  EXPECT_EQ(refused_body("<g id='a'>\n<g id='b'><use href='#a'/></g></g>"),
            nothing + "line 3: use: uses '#a' within itself");
  EXPECT_EQ(refused_body("<use id='u' href='#u'/>"),
            nothing + "line 2: use 'u': uses '#u' within itself");
  EXPECT_EQ(refused_body("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>"),
            nothing + "line 2: use: uses '#a' within itself");
}

TEST(BadSvg, CopiesOfCopiesAreBounded) {
  const auto copies = [](const std::string& first) {
    std::string body = first;
    for (int i = 1; i < 12; ++i) {
      body += "<g id='u" + std::to_string(i) + "'>" +
              repeated("<use href='#u" + std::to_string(i - 1) + "'/>", 10) + "</g>";
    }
    return body;
  };
  EXPECT_EQ(refused_body(copies("<path id='u0' d='M0 0L1 1 2 0'/>")),
            "line 2: path 'u0': more than 100000 layers are drawn");
  EXPECT_NE(refused_body(copies("<g id='u0'/>")).find("more than 1000000 elements are drawn"),
            std::string::npos);
  const std::string large = "<path id='u0' d='M0 0" + repeated("L1 1 0 0", 100000) + "'/>";
  EXPECT_EQ(refused_body(copies(large)), "line 2: path 'u0': more than 4000000 segments are drawn");
}

TEST(BadSvg, TooManyElementsAreRefused) {
  EXPECT_EQ(refused_body(repeated("<g/>", 1000001)), "line 2: more than 1000000 elements");
}

TEST(BadSvg, DeepNestingIsRefused) {
  const auto nested = [](int depth) {
    return repeated("<g>", depth) + "<circle r='1'/>" + repeated("</g>", depth);
  };
  EXPECT_EQ(refused_body(nested(100000)), "line 2: more than 256 elements in each other");
  EXPECT_EQ(test::read(nested(254)).drawing.layers.size(), 1U);
  EXPECT_EQ(refused_body(nested(255)), "line 2: more than 256 elements in each other");
  std::string chain = "<g id='u0'><circle r='1'/></g>";
  for (int i = 1; i < 300; ++i) {
    chain += "<g id='u" + std::to_string(i) + "'><use href='#u" + std::to_string(i - 1) + "'/></g>";
  }
  EXPECT_NE(refused_body("<defs>" + chain + "</defs><use href='#u299'/>").find("more than 256"),
            std::string::npos);
}

TEST(BadSvg, AMillionSegmentsAreRead) {
  std::string data = "M0 0";
  for (int i = 0; i < 1000000; ++i) {
    data += "C1.25 2.5 " + std::to_string(i % 97) + ".5 7.75 " + std::to_string(i % 89) + " 1";
  }
  EXPECT_EQ(test::path_of(data).at(0).segments.size(), 1000000U);
}

TEST(BadSvg, AttributesAreCountedAndNotCompared) {
  std::string many;
  for (int i = 0; i <= most_attributes; ++i) many += " a" + std::to_string(i) + "='\"'";
  EXPECT_EQ(refused("<svg>\n<path" + many + "/></svg>"),
            "line 2: an element has more than 10000 attributes");
  // What stands in comments and other sections is none.
  const std::string apart = repeated("'\"", 3 * most_attributes);
  EXPECT_NO_THROW(read_svg("<?a " + apart + "?><svg><!-- <a " + apart + " --><style><![CDATA[ <a " +
                           apart + "]]></style><path d='M0 0H9V9Z'/></svg>"));
}

TEST(BadSvg, StyleSheetsTakeSoManySteps) {
  EXPECT_EQ(
      refused("<svg><style>" + repeated("path{x:1;y:2}", 10'000) + "</style>" +
              repeated("<path d='M0 0H9V9Z'/>", 2'000) + "</svg>"),
      "more than " + std::to_string(StyleSheet::most_steps) + " steps to apply the style sheet");
}

TEST(BadSvg, AThousandWarningsAreTwentyAndACount) {
  std::string body = "<path d='M0 0H9V9Z'/>";
  for (int i = 0; i < 1000; ++i) body += "<x" + std::to_string(i % 500) + "/>";
  const auto warnings = read_svg("<svg><mystery/>" + body + "</svg>").warnings;
  ASSERT_EQ(warnings.size(), Warnings::most_of_a_kind + 1);
  EXPECT_EQ(warnings[0], "the element mystery is not supported");
  EXPECT_EQ(warnings.back(), "481 more like \"the element x18 is not supported\"");
}

}  // namespace
}  // namespace wavecurve::io
