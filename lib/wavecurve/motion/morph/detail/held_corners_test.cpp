#include "wavecurve/motion/morph/detail/held_corners.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/motion/morph/make_morph.hpp"

namespace wavecurve::motion {
namespace {

using Eigen::Index;

/// Two area charts over one base.
Contour chart(double left, double middle, double right) {
  return (Contour(5, 2) << 0, 100, 0, left, 50, middle, 100, right, 100, 100).finished();
}

struct Shape {
  explicit Shape(const Contour& corners, Index samples = 64)
      : path(polygon(corners)), points(sample_contour(corners, samples)) {}
  operator SampledPath() const { return {path, points}; }
  Subpath path;
  Contour points;
};

/// Whether the point is the same one in both contours, at the same place.
bool stays(const ContourPair& pair, double x, double y) {
  for (Index row = 0; row < pair.source.rows(); ++row) {
    if (pair.source(row, 0) != x || pair.source(row, 1) != y) continue;
    return pair.destination.row(row) == pair.source.row(row);
  }
  return false;
}

TEST(HeldPair, CornersThatBothShareStay) {
  const Shape from(chart(20, 60, 40)), to(chart(70, 10, 90));
  const auto pair = held_pair(from, to, {}, 1e-4);
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->source.rows(), 64);
  EXPECT_TRUE(stays(*pair, 0, 100));
  EXPECT_TRUE(stays(*pair, 100, 100));
  // The base is straight all the time: on it, points are at the same shares of the way.
  int on_base = 0;
  for (Index row = 0; row < 64; ++row) {
    if (pair->source(row, 1) != 100) continue;
    EXPECT_NEAR(pair->destination(row, 1), 100, 1e-9);
    EXPECT_NEAR(pair->destination(row, 0), pair->source(row, 0), 1e-9);
    ++on_base;
  }
  EXPECT_GT(on_base, 10);
}

TEST(HeldPair, NothingIsHeldWhereNothingIsShared) {
  const Shape from(chart(20, 60, 40));
  EXPECT_FALSE(held_pair(from, Shape(chart(20, 60, 40) * 0.9), {}, 1e-4));
  Contour circle(64, 2);
  for (Index i = 0; i < 64; ++i) {
    circle.row(i) << 50 + std::cos(0.1 * static_cast<double>(i)),
        std::sin(0.1 * static_cast<double>(i));
  }
  EXPECT_FALSE(held_pair(from, Shape(circle), {}, 1e-4));
}

TEST(HeldPair, SharedCornersInAnotherOrderAreHeldAsFarAsTheyFollow) {
  const Contour square = (Contour(4, 2) << 0, 0, 4, 0, 4, 4, 0, 4).finished();
  const Contour bow = (Contour(4, 2) << 0, 0, 4, 4, 4, 0, 0, 4).finished();
  const auto pair = held_pair(Shape(square), Shape(bow), {}, 1e-9);
  ASSERT_TRUE(pair);
  EXPECT_TRUE(stays(*pair, 0, 0));
  EXPECT_TRUE(pair->destination.allFinite());
}

TEST(HeldPair, VerticesCorrespondAsAsked) {
  const Shape from(chart(20, 60, 40)), to(chart(70, 10, 90));
  const auto pair = held_pair(from, to, {{0, 1}, {3, 4}}, 0);
  ASSERT_TRUE(pair);
  for (Index row = 0; row < 64; ++row) {
    if (pair->source.row(row) == Eigen::RowVector2d(0, 100)) {
      EXPECT_EQ(pair->destination.row(row), Eigen::RowVector2d(0, 70));
    }
    if (pair->source.row(row) == Eigen::RowVector2d(100, 40)) {
      EXPECT_EQ(pair->destination.row(row), Eigen::RowVector2d(100, 100));
    }
  }
  EXPECT_THROW(held_pair(from, to, {{0, 9}}, 0), std::invalid_argument);
  EXPECT_THROW(held_pair(from, to, {{0, 0}, {0, 1}}, 0), std::invalid_argument);
  EXPECT_THROW(held_pair(from, to, {{0, 0}, {1, 2}, {2, 1}}, 0), std::invalid_argument);
}

Drawing drawing_of(const std::vector<Contour>& contours) {
  Layer layer{"area", {}, {}};
  layer.paint.fill = Colour{};
  for (const Contour& contour : contours) layer.subpaths.push_back(polygon(contour));
  return {{0, 0, 100, 100}, {layer}};
}

MorphOptions options() {
  MorphOptions options;
  options.bank = find_filter_bank("bspline4.4");
  options.samples = 64;
  return options;
}

TEST(MakeMorph, HoldsTheBaseOfAChart) {
  const Animation animation = animate(
      make_morph(drawing_of({chart(20, 60, 40)}), drawing_of({chart(70, 10, 90)}), options()));
  for (const double time : {0.0, 0.7, 2.0}) {
    const Contour outline = frame_at(animation, time)[0].contours[0];
    for (const double x : {0.0, 100.0}) {
      EXPECT_LT((outline.rowwise() - Eigen::RowVector2d(x, 100)).rowwise().norm().minCoeff(), 1e-9)
          << time;
    }
  }
}

TEST(MakeMorph, HoldsNothingWhereSharedCornersAreIgnored) {
  MorphOptions uniform = options();
  uniform.shared_corners = Corners::ignored;
  const Animation animation = animate(
      make_morph(drawing_of({chart(20, 60, 40)}), drawing_of({chart(70, 10, 90)}), uniform));
  const Contour outline = frame_at(animation, 1)[0].contours[0];
  EXPECT_GT((outline.rowwise() - Eigen::RowVector2d(0, 100)).rowwise().norm().minCoeff(), 0.1);
}

TEST(MakeMorph, TakesAnchorsAndMapsOfContours) {
  const Contour small = (Contour(4, 2) << 0, 0, 9, 0, 9, 9, 0, 9).finished();
  const Contour far = small.rowwise() + Eigen::RowVector2d(80, 0);
  const Drawing both = drawing_of({small, far});
  MorphOptions crossed = options();
  crossed.contours = {{"area", 0, "area", 1}};
  const Animation animation = animate(make_morph(both, both, crossed));
  const auto middle = frame_at(animation, 1)[0].contours;
  for (const Contour& contour : middle) EXPECT_NEAR(contour.col(0).mean(), 44.5, 1e-9);

  MorphOptions anchored = options();
  anchored.anchors = {{"area", 0, 2}, {"area", 4, 6}};  // both squares turn by a half
  const auto turned = frame_at(animate(make_morph(both, both, anchored)), 1)[0].contours;
  for (const Contour& contour : turned) {
    EXPECT_LT((contour.rowwise() - contour.colwise().mean()).rowwise().norm().maxCoeff(), 1e-9);
  }

  const auto refused = [&](MorphOptions how) {
    EXPECT_THROW(make_morph(both, both, how), std::invalid_argument);
  };
  MorphOptions bad = options();
  bad.anchors = {{"nothing", 0, 0}};
  refused(bad);
  bad.anchors = {{"area", 0, 99}};
  refused(bad);
  bad.anchors = {{"area", 0, 5}};  // of two contours that are not matched
  refused(bad);
  bad.anchors = {{"area", 0, 1}};
  bad.starts = {{"area", 3}};
  refused(bad);
  bad = options();
  bad.contours = {{"area", 0, "area", 2}};
  refused(bad);
  bad.contours = {{"area", 0, "area", 1}, {"area", 0, "area", 0}};
  refused(bad);
}

}  // namespace
}  // namespace wavecurve::motion
