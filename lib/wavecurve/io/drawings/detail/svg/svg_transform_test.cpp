#include "wavecurve/io/drawings/detail/svg/svg_transform.hpp"

#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"

namespace wavecurve::io {
namespace {

const Viewport window{200, 100};

/// Where a transformation brings the point (10, 20).
void expect_image(const std::string& text, double x, double y) {
  SCOPED_TRACE(text);
  test::expect_near(parse_css_transform(text, window) * Eigen::Vector2d(10, 20), x, y, 1e-12);
}

TEST(SvgTransform, EveryFunction) {
  expect_image("none", 10, 20);
  expect_image("translate(1px, 2pt)", 11, 20 + 8.0 / 3);
  expect_image("translate(50%,50%)", 110, 70);
  expect_image("translateX(5px) translateY(6px)", 15, 26);
  expect_image("scale(2)", 20, 40);
  expect_image("scale(2, 50%)", 20, 10);
  expect_image("scaleX(3)scaleY(2)", 30, 40);
  expect_image("rotate(90deg)", -20, 10);
  expect_image("rotate(.25turn)", -20, 10);
  expect_image("rotate(100grad)", -20, 10);
  expect_image("skewX(45deg)", 30, 20);
  expect_image("skewY(45deg)", 10, 30);
  expect_image("skew(45deg, 0)", 30, 20);
  expect_image("matrix(1,2,3,4,5,6)", 75, 106);
  expect_image("translate(50px, 0) rotate(90deg)", 30, 10);
}

TEST(SvgTransform, WhatIsNoneIsNamed) {
  for (const char* bad : {"rotate(45)", "translate(5,6)", "rotate3d(1,1,1,5deg)", "scale()", "x",
                          "scale(2", "var(--t)", "matrix(1,2,3)"}) {
    EXPECT_EQ(test::refusal([&] { parse_css_transform(bad, window); }),
              "no transform of CSS: '" + std::string(bad) + "'");
  }
}

TEST(SvgTransform, TheOriginIsALengthAShareOrAWord) {
  const auto expect_origin = [](const char* text, double x, double y) {
    SCOPED_TRACE(text);
    test::expect_near(parse_transform_origin(text, window), x, y, 1e-12);
  };
  expect_origin("50 60", 50, 60);
  expect_origin("50px 10%", 50, 10);
  expect_origin("center", 100, 50);
  expect_origin("top left", 0, 0);
  expect_origin("bottom", 100, 100);
  expect_origin("right bottom 0", 200, 100);
  EXPECT_THROW(parse_transform_origin("up", window), std::invalid_argument);
  EXPECT_THROW(parse_transform_origin("left left", window), std::invalid_argument);
}

TEST(SvgTransform, ElementsFollowTheProperties) {
  const auto box = [](const std::string& attributes) {
    return test::box_of(
        test::only_layer("<rect x='40' y='40' width='20' height='20' " + attributes + "/>")
            .subpaths);
  };
  const double half = 10 * std::sqrt(2.0);
  const auto turned = box("transform='rotate(45)' transform-origin='50 50'");
  test::expect_near(turned.min(), 50 - half, 50 - half, 1e-9);
  test::expect_near(box("style='transform:rotate(45deg);transform-origin:center'").min(), 50 - half,
                    50 - half, 1e-9);
  // The property overrules the attribute.
  test::expect_near(box("style='transform:translate(5px)' transform='scale(9)'").min(), 45, 40,
                    1e-12);
  const DrawingFile bad = test::read("<rect width='9' height='9' transform='turn(3)'/>");
  EXPECT_EQ(bad.drawing.layers.size(), 1U);
  EXPECT_EQ(bad.warnings,
            std::vector<std::string>{"line 1: rect: no transformation after 0 characters, at "
                                     "'turn(3)'; it is left out"});
}

}  // namespace
}  // namespace wavecurve::io
