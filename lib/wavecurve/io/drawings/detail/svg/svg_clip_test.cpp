#include "wavecurve/io/drawings/detail/svg/svg_clip.hpp"

#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"

namespace wavecurve::io {
namespace {

std::vector<std::string> clipped(const std::string& shapes, const std::string& element,
                                 const std::string& attributes = "") {
  return test::read("<clipPath id='c' " + attributes + ">" + shapes + "</clipPath>" + element)
      .warnings;
}

const std::vector<std::string> nothing, told{"what leaves the clip path 'c' is not clipped"};
const std::string window = "<rect width='24' height='24'/>";

TEST(SvgClip, WhatContainsWhatItClipsIsNoReasonToWarn) {
  EXPECT_EQ(clipped(window, "<g clip-path='url(#c)'><path d='M2 2h20v20H2z'/></g>"), nothing);
  EXPECT_EQ(clipped(window, "<path clip-path='url(#c)' d='M0 0h24v24H0z'/>"), nothing);
  EXPECT_EQ(clipped(window, "<path style='clip-path:url(\"#c\")' d='M2 2h20v20H2z'/>"), nothing);
  EXPECT_EQ(clipped("<circle cx='50' cy='50' r='40'/>",
                    "<rect clip-path='url(#c)' x='30' y='30' width='40' height='40'/>"),
            nothing);
  // The clip path lies in the coordinates of the element.
  EXPECT_EQ(
      clipped(window, "<g clip-path='url(#c)' transform='scale(2)'><path d='M2 2h20v20H2z'/></g>"),
      nothing);
  EXPECT_EQ(clipped("<rect width='12' height='12' transform='scale(2)'/>",
                    "<path clip-path='url(#c)' d='M2 2h20v20H2z'/>"),
            nothing);
  EXPECT_EQ(clipped("<circle r='3'/>" + window, "<path clip-path='url(#c)' d='M2 2h20v20H2z'/>"),
            nothing);
}

TEST(SvgClip, WhatLeavesItIsToldOf) {
  EXPECT_EQ(clipped(window, "<path clip-path='url(#c)' d='M2 2h23v20H2z'/>"), told);
  EXPECT_EQ(clipped(window,
                    "<path clip-path='url(#c)' stroke='red' stroke-width='6' d='M2 2h20v20H2z'/>"),
            told);
  EXPECT_EQ(clipped("<circle cx='50' cy='50' r='40'/>",
                    "<rect clip-path='url(#c)' x='15' y='15' width='70' height='70'/>"),
            told);
  EXPECT_EQ(clipped("", "<path clip-path='url(#c)' d='M2 2h20v20H2z'/>"), told);
  // A star winds twice; whether it contains something is not looked at.
  EXPECT_EQ(clipped("<path d='M50 0L79 90 2 35H98L21 90z'/>",
                    "<path clip-path='url(#c)' d='M45 45h5v5h-5z'/>"),
            told);
  EXPECT_EQ(clipped("<rect width='1' height='1'/>", "<path clip-path='url(#c)' d='M2 2h20v20H2z'/>",
                    "clipPathUnits='objectBoundingBox'"),
            told);
  EXPECT_EQ(test::read("<path clip-path='none' d='M2 2h20v20H2z'/>").warnings, nothing);
}

}  // namespace
}  // namespace wavecurve::io
