#include "verification/stand_ins/frame_grid.hpp"

#include <string>

#include <gtest/gtest.h>

#include "verification/study/named_shapes.hpp"

namespace wavecurve::verification {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(FrameGrid, HasEveryFrameOverItsRestShape) {
  const Contour circle = unit_circle(8), star = named_shape("star", 8);
  const std::string svg = frame_grid({{"first", {star, circle}}, {"second", {circle, star}}},
                                     {"t = 0", "t = 1"}, circle);
  EXPECT_EQ(count(svg, "<g "), 4u);
  EXPECT_EQ(count(svg, "<path "), 8u);
  for (const char* label : {">first<", ">second<", ">t = 0<", ">t = 1<"}) {
    EXPECT_EQ(count(svg, label), 1u) << label;
  }
}

TEST(FrameGrid, PointsUpwards) {
  Contour peak(3, 2);
  peak << -1, 0, 1, 0, 0, 2;
  // The tip, with the largest y, is drawn above the centre: at a negative y of the cell.
  const std::string svg = frame_grid({{"", {peak}}}, {""}, peak);
  EXPECT_NE(svg.find(" 0 -56z"), std::string::npos) << svg;
}

}  // namespace
}  // namespace wavecurve::verification
