#include "wavecurve/motion/morph/detail/holes.hpp"

#include <chrono>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "wavecurve/motion/morph/detail/nesting.hpp"

namespace wavecurve::motion {
namespace {

/// A wavy ring about a centre, whose radii lie within a tenth of the one given.
Contour wavy_ring(const Eigen::Vector2d& centre, double radius, bool clockwise,
                  std::mt19937& random) {
  const int points = 3 + static_cast<int>(random() % 30),
            waves = 2 + static_cast<int>(random() % 5);
  const double phase = static_cast<double>(random() % 1000);
  Contour ring(points, 2);
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points + phase;
    const double r = radius * (1 + 0.1 * std::sin(waves * angle));
    ring.row(i) << centre.x() + r * std::cos(angle), centre.y() + r * std::sin(angle);
  }
  if (!clockwise) ring = ring.colwise().reverse().eval();
  return ring;
}

/// Rings in rings: each has up to three of them inside, apart from each other.
void add_rings(std::vector<Contour>& outline, const Eigen::Vector2d& centre, double radius,
               int depth, std::mt19937& random) {
  outline.push_back(wavy_ring(centre, radius, random() % 2 == 0, random));
  if (depth == 0) return;
  const int inner = static_cast<int>(random() % 4);
  for (int i = 0; i < inner; ++i) {
    // A triangle's inner circle has half of the radius of its corners, and waves take a tenth of that: the
    // rings about centres at 0.2 of the radius, 0.34 apart, stay below 0.2 + 0.11 of it.
    const double angle = 2 * std::numbers::pi * i / 3;
    const Eigen::Vector2d aside(std::cos(angle), std::sin(angle));
    add_rings(outline, centre + 0.2 * radius * aside, 0.1 * radius, depth - 1, random);
  }
}

TEST(Holes, AreThoseOfThePlainWay) {
  std::mt19937 random(5);
  int found = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Contour> outline;
    for (int i = 0; i < 3; ++i) add_rings(outline, {3.0 * i, 0.5 * i}, 1, 4, random);
    std::shuffle(outline.begin(), outline.end(), random);
    for (const FillRule rule : {FillRule::evenodd, FillRule::nonzero}) {
      const std::vector<bool> swept = holes(outline, rule, 0);
      for (std::size_t i = 0; i < outline.size(); ++i) {
        ASSERT_EQ(swept[i], is_hole(outline, i, rule)) << "trial " << trial << ", contour " << i;
        found += swept[i];
      }
    }
  }
  EXPECT_GT(found, 300);
}

TEST(Holes, OfBoxesWithHorizontalEdges) {
  std::vector<Contour> boxes;
  for (int i = 0; i < 40; ++i) {
    Contour box(8, 2);  // with the middles of its sides
    box << -1, -1, 0, -1, 1, -1, 1, 0, 1, 1, 0, 1, -1, 1, -1, 0;
    boxes.push_back(((1.0 + i % 20) * box).rowwise() + Eigen::RowVector2d(100 * (i / 20), 0));
  }
  for (const FillRule rule : {FillRule::evenodd, FillRule::nonzero}) {
    const std::vector<bool> swept = holes(boxes, rule, 0);
    for (std::size_t i = 0; i < boxes.size(); ++i)
      EXPECT_EQ(swept[i], is_hole(boxes, i, rule)) << i;
  }
}

TEST(Holes, EndInAnyOutline) {
  // Random polygons cross themselves and each other: no answer is right, but there is one, at once.
  std::mt19937 random(7);
  std::vector<Contour> outline(20000);
  for (Contour& contour : outline) {
    contour.resize(6, 2);
    for (int i = 0; i < 6; ++i) contour.row(i) << double(random() % 50), double(random() % 50);
  }
  outline.front().setZero();
  EXPECT_EQ(holes(outline, FillRule::evenodd).size(), outline.size());
}

TEST(Holes, OfAHundredThousandNestedContoursTakeSeconds) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<Contour> outline;
  std::mt19937 random(1);
  for (int i = 0; i < 100000; ++i) {
    Contour diamond(4, 2);
    diamond << 0, -1, 1, 0, 0, 1, -1, 0;
    outline.push_back((1 + 1e-5 * i) * diamond);
  }
  const std::vector<bool> swept = holes(outline, FillRule::evenodd);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    ASSERT_EQ(swept[i], (outline.size() - 1 - i) % 2 == 1) << i;
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));  // 0.3 s measured
}

}  // namespace
}  // namespace wavecurve::motion
