#include "wavecurve/motion/morph/detail/painting_order.hpp"

#include <gtest/gtest.h>

namespace wavecurve::motion {
namespace {

FrameLayer square(double x, double size = 1) {
  Contour points(4, 2);
  points << 0, 0, size, 0, size, size, 0, size;
  return {"", {points.rowwise() + Eigen::RowVector2d(x, 0)}, {}};
}

FrameLayer coloured(FrameLayer layer, Colour colour) {
  layer.paint.fill = colour;
  return layer;
}

std::vector<std::optional<std::size_t>> sources(const std::vector<LayerMatch>& matches) {
  std::vector<std::optional<std::size_t>> places;
  for (const LayerMatch& match : matches) places.push_back(match.source);
  return places;
}

using Places = std::vector<std::optional<std::size_t>>;

// Apart in the source, on top of each other in the destination, the other way round.
TEST(PaintingOrder, FollowsTheDestinationWhereTheSourceLeavesItOpen) {
  const std::vector<FrameLayer> apart{square(0), square(5)}, together{square(0), square(0.5)};
  const std::vector<LayerMatch> matches{{0, 1}, {1, 0}};
  EXPECT_EQ(sources(painting_order(matches, apart, together)), (Places{1, 0}));
  EXPECT_EQ(sources(painting_order(matches, together, apart)), (Places{0, 1}));
  EXPECT_EQ(sources(painting_order(matches, together, together)), (Places{0, 1}));
  EXPECT_EQ(sources(painting_order(matches, apart, apart)), (Places{0, 1}));
}

TEST(PaintingOrder, PutsNewLayersWhereTheyLie) {
  // New ones below and above the only common layer.
  const std::vector<FrameLayer> one{square(0)}, three{square(0), square(0.2), square(0.4)};
  const std::vector<LayerMatch> matches{{0, 1}, {std::nullopt, 0}, {std::nullopt, 2}};
  EXPECT_EQ(sources(painting_order(matches, one, three)), (Places{std::nullopt, 0, std::nullopt}));
}

// The boxes of two triangles overlap in the source, they themselves do not.
TEST(PaintingOrder, LooksAtOutlinesWhereTheEndsContradictEachOther) {
  Contour upper(3, 2), lower(3, 2);
  upper << 0, 0, 4, 0, 0, 4;
  lower << 5, 1, 5, 5, 1, 5;
  const std::vector<FrameLayer> source{{"", {upper}, {}}, {"", {lower}, {}}};
  const std::vector<FrameLayer> destination{square(0), square(0.5)};
  EXPECT_EQ(sources(painting_order({{0, 1}, {1, 0}}, source, destination)), (Places{1, 0}));
}

TEST(PaintingOrder, TheEndsMayContradictEachOther) {
  const std::vector<FrameLayer> both{square(0), coloured(square(0.5), {1, 0, 0})};
  const std::vector<LayerMatch> crossed{{0, 1}, {1, 0}};
  EXPECT_EQ(sources(painting_order(crossed, both, both)), (Places{0, 1}));
  EXPECT_EQ(final_painting_order(crossed, both, both), (std::vector<std::size_t>{1, 0}));
  // Nobody sees which of two layers of one colour is the upper one.
  const std::vector<FrameLayer> alike{coloured(square(0), {}), coloured(square(0.5), {})};
  EXPECT_EQ(final_painting_order(crossed, alike, alike), (std::vector<std::size_t>{0, 1}));
}

// Corners of each lie on the outline of the other, and no edges cross.
TEST(PaintingOrder, AStripeAsWideAsItsGroundLiesOnIt) {
  Contour stripe(4, 2);
  stripe << 0, 1, 4, 1, 4, 2, 0, 2;
  const FrameLayer ground = square(0, 4), upper = coloured({"", {stripe}, {}}, {1, 0, 0});
  const std::vector<FrameLayer> ground_below{ground, upper}, ground_above{upper, ground};
  const std::vector<LayerMatch> matches{{0, 1}, {1, 0}};
  EXPECT_EQ(sources(painting_order(matches, ground_below, ground_above)), (Places{0, 1}));
  EXPECT_EQ(final_painting_order(matches, ground_below, ground_above),
            (std::vector<std::size_t>{1, 0}));
}

TEST(PaintingOrder, WhatLiesOnAnExchangedLayerGoesWithIt) {
  // In the source 0 < 1, on which 2 vanishes; in the destination 1 < 0.
  const std::vector<FrameLayer> source{square(0), coloured(square(0), {1, 0, 0}), square(0.2)};
  const std::vector<FrameLayer> destination{coloured(square(0), {1, 0, 0}), square(0)};
  const std::vector<LayerMatch> matches{{1, 0}, {0, 1}, {2, std::nullopt}};
  const auto start = painting_order(matches, source, destination);
  ASSERT_EQ(sources(start), (Places{0, 1, 2}));
  EXPECT_EQ(final_painting_order(start, source, destination), (std::vector<std::size_t>{1, 0, 2}));
}

TEST(PaintingOrder, MeetsEachEndWhereDemandsGoRound) {
  // In the source 0 < 1, in the destination 1 < 2 < 0.
  const std::vector<FrameLayer> source{square(0), square(0.5), square(9)};
  const std::vector<FrameLayer> destination{square(5), square(4.2), square(5.8)};
  const std::vector<LayerMatch> matches{{0, 2}, {1, 1}, {2, 0}};
  const auto start = painting_order(matches, source, destination);
  EXPECT_EQ(start.size(), 3u);
  EXPECT_EQ(final_painting_order(start, source, destination).size(), 3u);
}

}  // namespace
}  // namespace wavecurve::motion
