#include "wavecurve/motion/morph/detail/orientation.hpp"

#include <chrono>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <random>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "wavecurve/curves/signed_area.hpp"
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

Contour polygon(std::initializer_list<std::pair<double, double>> points, int parts = 8) {
  Contour contour(static_cast<Eigen::Index>(points.size()) * parts, 2);
  Eigen::Index row = 0;
  for (auto point = points.begin(); point != points.end(); ++point) {
    const auto& next = point + 1 == points.end() ? *points.begin() : *(point + 1);
    for (int i = 0; i < parts; ++i) {
      const double share = static_cast<double>(i) / parts;
      contour.row(row++) << std::lerp(point->first, next.first, share),
          std::lerp(point->second, next.second, share);
    }
  }
  return contour;
}

int winding(const std::vector<Contour>& outline, const Eigen::Vector2d& point) {
  int sum = 0;
  for (const Contour& contour : outline) sum += winding_number(contour, point);
  return sum;
}

/// The random points that the oriented outline fills otherwise than the outline, by each of the
/// rules that it says to be alike.
int wrong_points(const std::vector<Contour>& outline, FillRule rule, double most_plain = 1e7) {
  const Orientation turned = oriented(outline, rule, most_plain);
  EXPECT_TRUE(turned.nonzero || turned.evenodd);
  Eigen::AlignedBox2d box;
  for (const Contour& contour : outline) {
    for (Eigen::Index i = 0; i < contour.rows(); ++i) box.extend(contour.row(i).transpose());
  }
  int wrong = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d point = box.sample();
    const bool filled = is_filled(winding(outline, point), rule);
    const int now = winding(turned.contours, point);
    if (turned.nonzero) wrong += is_filled(now, FillRule::nonzero) != filled;
    if (turned.evenodd) wrong += is_filled(now, FillRule::evenodd) != filled;
  }
  return wrong;
}

TEST(Orientation, FillsAsTheOutlineDoes) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Contour> outline;
    for (int i = 0; i < 3; ++i) add_rings(outline, {3.0 * i, 0.5 * i}, 1, 4, random);
    std::shuffle(outline.begin(), outline.end(), random);
    for (const FillRule rule : {FillRule::evenodd, FillRule::nonzero}) {
      EXPECT_EQ(wrong_points(outline, rule), 0) << trial;
      EXPECT_EQ(wrong_points(outline, rule, 0), 0) << trial;
      const auto swept = oriented(outline, rule, 0), plain = oriented(outline, rule);
      for (std::size_t i = 0; i < outline.size(); ++i) {
        ASSERT_EQ(swept.contours[i], plain.contours[i]) << "trial " << trial << ", contour " << i;
      }
    }
  }
}

TEST(Orientation, IsRightForContoursThatCrossOrTouch) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Contour> outline;
    const auto some = [&] { return static_cast<double>(random() % 20); };
    const int contours = 1 + static_cast<int>(random() % 6);
    for (int i = 0; i < contours; ++i) {
      outline.push_back(polygon({{some(), some()}, {some(), some()}, {some(), some()}}));
    }
    for (const FillRule rule : {FillRule::evenodd, FillRule::nonzero}) {
      EXPECT_EQ(wrong_points(outline, rule), 0) << trial;
    }
  }
}

TEST(Orientation, IsRightForHolesWhoseFirstVertexLiesElsewhere) {
  const Contour body = polygon({{10, 20}, {90, 20}, {90, 90}, {10, 90}});
  const Contour tab = polygon({{40, 10}, {60, 10}, {60, 30}, {40, 30}});
  const Contour hole = polygon({{50, 25}, {20, 80}, {80, 80}});
  EXPECT_EQ(wrong_points({body, tab, hole}, FillRule::nonzero), 0);
  EXPECT_EQ(wrong_points({polygon({{5, 5}, {95, 5}, {95, 95}, {5, 95}}),
                          polygon({{50, 50}, {50, 20}, {20, 20}, {20, 50}}),
                          polygon({{50, 50}, {50, 80}, {80, 80}, {80, 50}})},
                         FillRule::nonzero),
            0);
}

TEST(Orientation, OuterContoursClockwiseHolesNot) {
  const Contour outer = polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}});
  const Contour inner = polygon({{3, 3}, {6, 3}, {6, 6}, {3, 6}});
  const auto turns = [&](const Contour& second, std::optional<FillRule> rule) {
    const Orientation turned = oriented({outer, second}, rule);
    EXPECT_EQ(turned.contours[1].row(0), second.row(0));
    EXPECT_GT(signed_area(turned.contours[0]), 0);
    return signed_area(turned.contours[1]) > 0;
  };
  const Contour back = inner.colwise().reverse();
  EXPECT_FALSE(turns(inner, FillRule::evenodd));
  EXPECT_TRUE(turns(inner, FillRule::nonzero));
  EXPECT_FALSE(turns(back, FillRule::nonzero));
  EXPECT_TRUE(turns(back, std::nullopt));
}

TEST(Orientation, IsRightForBoxesWithHorizontalEdges) {
  std::vector<Contour> boxes;
  for (int i = 0; i < 40; ++i) {
    Contour box(8, 2);  // with the middles of its sides
    box << -1, -1, 0, -1, 1, -1, 1, 0, 1, 1, 0, 1, -1, 1, -1, 0;
    boxes.push_back(((1.0 + i % 20) * box).rowwise() + Eigen::RowVector2d(100 * (i / 20), 0));
  }
  for (const FillRule rule : {FillRule::evenodd, FillRule::nonzero}) {
    EXPECT_EQ(wrong_points(boxes, rule, 0), 0);
  }
}

TEST(Orientation, EndInAnyOutline) {
  // Random polygons cross themselves and each other: no answer is right, but there is one, at once.
  std::mt19937 random(7);
  std::vector<Contour> outline(20000);
  for (Contour& contour : outline) {
    contour.resize(6, 2);
    for (int i = 0; i < 6; ++i) contour.row(i) << double(random() % 50), double(random() % 50);
  }
  outline.front().setZero();
  EXPECT_EQ(oriented(outline, FillRule::evenodd).contours.size(), outline.size());
}

TEST(Orientation, TakesSecondsForAHundredThousandNestedContours) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<Contour> outline;
  std::mt19937 random(1);
  for (int i = 0; i < 100000; ++i) {
    Contour diamond(4, 2);
    diamond << 0, -1, 1, 0, 0, 1, -1, 0;
    outline.push_back((1 + 1e-5 * i) * diamond);
  }
  const Orientation swept = oriented(outline, FillRule::evenodd);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    ASSERT_EQ(signed_area(swept.contours[i]) < 0, (outline.size() - 1 - i) % 2 == 1) << i;
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));  // 0.3 s measured
}

}  // namespace
}  // namespace wavecurve::motion
