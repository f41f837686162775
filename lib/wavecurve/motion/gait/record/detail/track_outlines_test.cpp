#include "wavecurve/motion/gait/record/detail/track_outlines.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/signed_area.hpp"

namespace wavecurve::gait {
namespace {

using Eigen::Index;

/// A shape without symmetry that swings and bends as a limb does, from a place on its outline.
Contour limb(Index count, double phase, double start) {
  Contour outline(count, 2);
  const double swing = 0.5 * std::sin(2 * std::numbers::pi * phase);
  for (Index k = 0; k < count; ++k) {
    const double u =
        2 * std::numbers::pi * (static_cast<double>(k) / static_cast<double>(count) + start);
    const Eigen::Vector2d point(10 * std::cos(u) + 3 * std::cos(2 * u + 1),
                                40 * std::sin(u) + (4 + swing) * std::sin(3 * u));
    outline.row(k) = (Eigen::Rotation2Dd(swing) * point).transpose();
  }
  return outline;
}

double largest_step(const std::vector<Contour>& outlines) {
  double largest = 0;
  for (std::size_t i = 1; i < outlines.size(); ++i) {
    const double step = (outlines[i] - outlines[i - 1]).rowwise().norm().maxCoeff();
    largest = std::max(largest, step);
  }
  return largest;
}

TEST(TrackOutlines, TheStartDoesNotJump) {
  constexpr int frames = 60;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(0, 1);
  std::vector<Contour> traced, marked;
  for (int i = 0; i < frames; ++i) {
    const double phase = static_cast<double>(i) / frames;
    const Index count = 700 + 13 * i;
    marked.push_back(limb(count, phase, 0));
    traced.push_back(limb(count, phase, anywhere(random)));
    if (i % 3 == 1) traced.back() = traced.back().colwise().reverse().eval();
  }
  EXPECT_FALSE(correspond(traced));
  const auto tracked = track_outlines(traced, 128);
  for (const Contour& outline : tracked) {
    EXPECT_EQ(outline.rows(), 128);
    EXPECT_GT(signed_area(outline), 0);
  }
  EXPECT_TRUE(correspond(tracked));
  // Points that are followed exactly move by at most 55 * 0.5 * 2 pi / 60 < 2.9 a frame. Found is
  // the start to half of a quarter of a sample, of about 190 / 128.
  EXPECT_LT(largest_step(tracked), 2.9 + 0.2);
}

TEST(TrackOutlines, ThereAndBackIsNoDrift) {
  // After whole cycles the start is where it was, but for the resolution at every turning point.
  std::vector<Contour> traced;
  for (int i = 0; i <= 120; ++i) traced.push_back(limb(1000, i / 40.0, 0.37 * i));
  const auto tracked = track_outlines(traced, 256);
  const double spacing = 190.0 / 256;
  EXPECT_LT((tracked.back() - tracked.front()).rowwise().norm().maxCoeff(), 2 * spacing);
}

TEST(TrackOutlines, WhatCorrespondsIsToldFromWhatDoesNot) {
  std::vector<Contour> outlines;
  for (int i = 0; i < 20; ++i) outlines.push_back(limb(256, i / 20.0, 0));
  EXPECT_TRUE(correspond(outlines));
  auto jumping = outlines;
  jumping[7] = started_at(jumping[7], 40);
  EXPECT_FALSE(correspond(jumping));
  auto unequal = outlines;
  unequal[7] = limb(128, 7 / 20.0, 0);
  EXPECT_FALSE(correspond(unequal));
  EXPECT_FALSE(correspond({limb(100, 0, 0), limb(100, 0, 0)}));
  EXPECT_FALSE(correspond({limb(2, 0, 0), limb(2, 0, 0)}));
}

TEST(TrackOutlines, BadInputIsRefused) {
  EXPECT_THROW(track_outlines({limb(100, 0, 0)}, 100), std::invalid_argument);
  EXPECT_THROW(track_outlines({Contour::Zero(5, 2)}, 64), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::gait
