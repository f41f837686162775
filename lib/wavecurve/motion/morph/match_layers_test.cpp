#include "wavecurve/motion/morph/match_layers.hpp"

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::motion {
namespace {

constexpr double diagonal = 10;

/// A square of a colour about (x, y).
FrameLayer square(const std::string& id, double x, double y, double size, Colour colour) {
  Contour points(4, 2);
  points << -1, -1, 1, -1, 1, 1, -1, 1;
  FrameLayer layer{id, {(size / 2 * points).rowwise() + Eigen::RowVector2d(x, y)}, {}};
  layer.paint.fill = colour;
  return layer;
}

const Colour red{1, 0, 0}, blue{0, 0, 1}, dark_red{0.8, 0, 0};

/// "a>b" for a match, "a>" and ">b" for one alone.
std::set<std::string> matched(const std::vector<FrameLayer>& source,
                              const std::vector<FrameLayer>& destination,
                              const LayerMap& map = {}) {
  std::set<std::string> pairs;
  for (const LayerMatch& match : match_layers(source, destination, diagonal, map)) {
    pairs.insert((match.source ? source[*match.source].id : "") + ">" +
                 (match.destination ? destination[*match.destination].id : ""));
  }
  return pairs;
}

using Pairs = std::set<std::string>;

TEST(MatchLayers, ByIdThoughShapesDisagree) {
  const std::vector<FrameLayer> a{square("eye", 2, 2, 1, red), square("nose", 8, 8, 3, blue)};
  const std::vector<FrameLayer> b{square("nose", 2, 2, 1, red), square("eye", 8, 8, 3, blue)};
  EXPECT_EQ(matched(a, b), (Pairs{"eye>eye", "nose>nose"}));
}

TEST(MatchLayers, ByShapeWhereIdsAreNumbers) {
  const std::vector<FrameLayer> a{square("L0", 2, 2, 1, red), square("L1", 8, 8, 3, blue)};
  const std::vector<FrameLayer> b{square("L0", 8, 7, 3, blue), square("L1", 2, 3, 1, dark_red)};
  EXPECT_EQ(matched(a, b), (Pairs{"L0>L1", "L1>L0"}));
  const std::vector<FrameLayer> c{square("path-1", 2, 2, 1, red), square("rect-1", 8, 8, 3, blue)};
  const std::vector<FrameLayer> d{square("path-1", 8, 7, 3, blue), square("rect-1", 2, 3, 1, red)};
  EXPECT_EQ(matched(c, d), (Pairs{"path-1>rect-1", "rect-1>path-1"}));
}

TEST(MatchLayers, EachPartOfTheCostDecides) {
  const auto by = [](const FrameLayer& near, const FrameLayer& far) {
    return matched({square("a", 5, 5, 2, red)}, {far, near});
  };
  EXPECT_EQ(by(square("near", 5, 6, 2, red), square("far", 5, 8, 2, red)),
            (Pairs{"a>near", ">far"}));
  EXPECT_EQ(by(square("near", 5, 5, 3, red), square("far", 5, 5, 6, red)),
            (Pairs{"a>near", ">far"}));
  EXPECT_EQ(by(square("near", 5, 5, 2, dark_red), square("far", 5, 5, 2, blue)),
            (Pairs{"a>near", ">far"}));
}

TEST(MatchLayers, TheMapComesFirst) {
  const std::vector<FrameLayer> a{square("eye", 2, 2, 1, red), square("nose", 8, 8, 3, blue)};
  const std::vector<FrameLayer> b{square("eye", 2, 2, 1, red), square("nose", 8, 8, 3, blue)};
  EXPECT_EQ(matched(a, b, {{"eye", "nose"}}), (Pairs{"eye>nose", "nose>eye"}));
}

TEST(MatchLayers, LeavesTheRestAlone) {
  const std::vector<FrameLayer> a{square("x", 2, 2, 1, red), square("y", 8, 8, 1, red)};
  EXPECT_EQ(matched(a, {square("z", 8, 7, 1, red)}), (Pairs{"x>", "y>z"}));
}

TEST(MatchLayers, RefusesAMapThatFitsNotOrTwice) {
  const std::vector<FrameLayer> a{square("x", 2, 2, 1, red), square("y", 8, 8, 1, red)};
  EXPECT_THROW(match_layers(a, a, diagonal, {{"x", "q"}}), std::invalid_argument);
  EXPECT_THROW(match_layers(a, a, diagonal, {{"q", "x"}}), std::invalid_argument);
  EXPECT_THROW(match_layers(a, a, diagonal, {{"x", "y"}, {"y", "y"}}), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::motion
