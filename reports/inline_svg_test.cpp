#include "reports/inline_svg.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace wavecurve::reports {
namespace {

const std::string document =
    "<?xml version=\"1.0\"?>\n<!-- made by a program -->\n"
    "<svg width=\"10\" height=\"20\" role='presentation' xmlns=\"http://www.w3.org/2000/svg\">\n"
    "<title>Gnuplot</title>\n<desc>Produced by GNUPLOT</desc>\n"
    "<defs>\n\t<path id='mark' d='M0,0'/><clipPath id=\"clip\"/></defs>\n"
    "<g clip-path=\"url(#clip)\"><use xlink:href='#mark'/><use href=\"#mark\"/></g></svg>\n";

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(InlineSvg, PrefixesEveryIdAndEveryReference) {
  const std::string svg = inline_svg(document, "p-", "T", "D");
  EXPECT_TRUE(has(svg, "id='p-mark'"));
  EXPECT_TRUE(has(svg, "id=\"p-clip\""));
  EXPECT_TRUE(has(svg, "url(#p-clip)"));
  EXPECT_TRUE(has(svg, "xlink:href='#p-mark'"));
  EXPECT_TRUE(has(svg, " href=\"#p-mark\""));
}

TEST(InlineSvg, IsNamedForScreenReadersAndScales) {
  const std::string svg = inline_svg(document, "p-", "a < b", "c & d");
  EXPECT_TRUE(svg.starts_with("<svg role=\"img\" aria-labelledby=\"p-title p-desc\""));
  EXPECT_TRUE(has(svg, "<title id=\"p-title\">a &lt; b</title>"));
  EXPECT_TRUE(has(svg, "<desc id=\"p-desc\">c &amp; d</desc>"));
  EXPECT_TRUE(has(svg, "viewBox=\"0 0 10 20\""));
  EXPECT_FALSE(has(svg, "presentation"));
  EXPECT_FALSE(has(svg, "Gnuplot"));
  EXPECT_FALSE(has(svg, "GNUPLOT"));
  EXPECT_FALSE(has(svg, "<?xml"));
  EXPECT_TRUE(svg.ends_with("</svg>"));
}

TEST(InlineSvg, KeepsAViewBoxThatIsThere) {
  const std::string svg =
      inline_svg("<svg viewBox='0 0 3 4' width='30' height='40'><g/></svg>", "p-", "T", "D");
  EXPECT_TRUE(has(svg, "viewBox='0 0 3 4'"));
  EXPECT_FALSE(has(svg, "viewBox=\""));
}

TEST(InlineSvg, SurvivesOddTagsAndRefusesWhatIsNoSvg) {
  EXPECT_TRUE(has(inline_svg("<svg></svg>", "p-", "T", "D"), "</desc></svg>"));
  EXPECT_TRUE(has(inline_svg("<svg a b=></svg>", "p-", "T", "D"), "</svg>"));
  EXPECT_TRUE(has(inline_svg("<svg a=\"></svg>", "p-", "T", "D"), "</svg>"));
  for (const char* text : {"", "<html></html>", "<svg", "</svg><svg>"}) {
    EXPECT_THROW(inline_svg(text, "p-", "T", "D"), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace wavecurve::reports
