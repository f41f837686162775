#include "verification/stand_ins/frame_sheet.hpp"

#include <string>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(FrameSheet, HasEveryFrameOnItsGround) {
  Contour triangle(3, 2);
  triangle << 0, 0, 10, 0, 0, 10;
  motion::FrameLayer layer{"a", {triangle}, {}};
  layer.paint.fill = Colour{1, 0, 0};
  const std::string svg = frame_sheet({{"first", {{layer}, {layer, layer}}}, {"second", {{layer}}}},
                                      {"0", "1"}, {0, 0, 100, 50}, 40);
  EXPECT_EQ(count(svg, "viewBox=\"0 0 100 50\""), 3u);
  EXPECT_EQ(count(svg, "d=\"M0 40h100\""), 3u);
  EXPECT_EQ(count(svg, "#ff0000"), 4u);
  for (const char* label : {">first<", ">second<", ">0<", ">1<"}) EXPECT_EQ(count(svg, label), 1u);
}

}  // namespace
}  // namespace wavecurve::verification
