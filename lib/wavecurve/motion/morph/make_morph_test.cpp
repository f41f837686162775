#include "wavecurve/motion/morph/make_morph.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/motion/detail/check_animation.hpp"

namespace wavecurve::motion {
namespace {

using Eigen::Index;

Subpath rectangle(double x, double y, double width, double height) {
  Contour points(4, 2);
  points << x, y, x + width, y, x + width, y + height, x, y + height;
  return polygon(points);
}

Layer layer(const std::string& id, std::vector<Subpath> subpaths, Colour fill) {
  Layer result{id, std::move(subpaths), {}};
  result.paint.fill = fill;
  return result;
}

/// A face with a patch that has a hole, and a mouth.
Drawing first() {
  Layer patch = layer("patch", {rectangle(2, 2, 3, 3), rectangle(3, 3, 1, 1)}, {1, 0, 0});
  patch.paint.fill_rule = FillRule::evenodd;
  return {{0, 0, 10, 10},
          {layer("face", {rectangle(1, 1, 8, 8)}, {1, 1, 0}), patch,
           layer("mouth", {rectangle(4, 7, 2, 1)}, {0, 0, 0})}};
}

/// Twice as large; the patch without its hole and in two pieces, and a hat for the mouth.
Drawing second() {
  return {{0, 0, 20, 20},
          {layer("face", {rectangle(4, 4, 14, 14)}, {0, 1, 1}),
           layer("patch", {rectangle(6, 6, 4, 4), rectangle(12, 6, 4, 4)}, {0, 0, 1}),
           layer("mouth", {rectangle(8, 13, 4, 2)}, {0, 0, 0}),
           layer("hat", {rectangle(6, 1, 8, 3)}, {0, 0, 0})}};
}

MorphOptions options() { return {.bank = find_filter_bank("db4"), .samples = 64}; }

/// The largest distance of a point of one contour from the nearest of another.
double distance(const Contour& a, const Contour& b) {
  double largest = 0;
  for (Index i = 0; i < a.rows(); ++i) {
    largest = std::max(largest, (b.rowwise() - a.row(i)).rowwise().norm().minCoeff());
  }
  return largest;
}

// Coordinates up to 20 through two transforms of four levels.
constexpr double rounding = 1e-12;

TEST(MakeMorph, EndsAreTheDrawings) {
  const Drawing a = first(), b = second();
  for (const Detail detail : {Detail::blend, Detail::stage}) {
    MorphOptions how = options();
    how.detail = detail;
    how.scale = 16;
    const Animation animation = animate(make_morph(a, b, how));
    check_animation(animation);
    ASSERT_EQ(animation.layers.size(), 4u);
    EXPECT_EQ(animation.view_box, a.view_box);
    const auto start = frame_at(animation, 0), end = frame_at(animation, animation.duration);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(start[i].id, a.layers[i].id);
      const auto samples = sample_layer(a.layers[i], 64);
      EXPECT_LT(distance(start[i].contours[0], samples[0]), rounding);
      EXPECT_EQ(start[i].paint.fill, a.layers[i].paint.fill);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      // The view box of the second is twice as large.
      const auto samples = sample_layer(b.layers[i], 64);
      EXPECT_LT(distance(2 * end[i].contours[0], samples[0]), rounding);
      EXPECT_EQ(end[i].paint.fill, b.layers[i].paint.fill);
    }
    EXPECT_LT((start[3].contours[0].rowwise() - start[3].contours[0].row(0)).norm(), rounding);
  }
}

TEST(MakeMorph, PiecesGrowAndHolesShrink) {
  const Animation animation = animate(make_morph(first(), second(), options()));
  const AnimatedLayer& patch = animation.layers[1];
  ASSERT_EQ(patch.outline[0].contours.size(),
            3u);  // a pair, a piece that appears, a hole that goes
  const auto extent = [&](std::size_t key, std::size_t contour) {
    const Contour& points = patch.outline[key].contours[contour];
    return (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
  };
  EXPECT_LT(extent(0, 1), rounding);
  EXPECT_NEAR(extent(1, 1), 2, rounding);
  EXPECT_NEAR(extent(0, 2), 1, rounding);
  EXPECT_LT(extent(1, 2), rounding);
  EXPECT_EQ(patch.paint[0].paint.fill_rule, FillRule::nonzero);
}

Drawing of_layers(std::vector<Layer> layers) { return {{0, 0, 10, 10}, std::move(layers)}; }

Layer outline(const std::string& id, std::vector<Subpath> subpaths, double width) {
  Layer result{id, std::move(subpaths), {}};
  result.paint.stroke = Colour{0, 1, 0};
  result.paint.stroke_width = width;
  return result;
}

TEST(MakeMorph, AnOutlineFillsFromItsRim) {
  const Drawing from = of_layers({outline("a", {rectangle(2, 2, 6, 6)}, 1)});
  const Drawing to = of_layers({layer("a", {rectangle(1, 1, 8, 8)}, {1, 0, 0})});
  const Animation animation = animate(make_morph(from, to, options()));
  check_animation(animation);
  ASSERT_EQ(animation.layers.size(), 2u);  // the fill and its rim
  double area_before = -1;
  for (const double time : {0.0, 0.5, 1.0, 1.5, 2.0}) {
    const auto frame = frame_at(animation, time);
    double area = 0;
    for (const Contour& contour : frame[0].contours) area += signed_area(contour);
    EXPECT_GT(area, area_before) << time;  // a ring that closes
    area_before = area;
    EXPECT_EQ(frame[0].paint.fill_opacity, 1);
    EXPECT_EQ(frame[1].paint.stroke_opacity, 1);
    EXPECT_NEAR(frame[1].paint.stroke_width, 1 - time / 2, 1e-12);
    EXPECT_EQ(frame[0].paint.fill, frame[1].paint.stroke);
  }
  EXPECT_NEAR(area_before, 64, 1e-9);
}

TEST(MakeMorph, AStrokedContourThatAppearsHasNoWidthBefore) {
  const Subpath large = rectangle(1, 1, 8, 8), small = rectangle(4, 4, 2, 2);
  const Animation animation =
      animate(make_morph(of_layers({outline("a", {large}, 1)}),
                         of_layers({outline("a", {large, small}, 1)}), options()));
  ASSERT_EQ(animation.layers.size(), 2u);
  EXPECT_EQ(frame_at(animation, 0)[0].paint.stroke_width, 1);
  EXPECT_EQ(frame_at(animation, 0)[1].paint.stroke_width, 0);
  EXPECT_EQ(frame_at(animation, 2)[1].paint.stroke_width, 1);
}

TEST(MakeMorph, OpenLinesStayOpen) {
  Subpath line = rectangle(1, 1, 8, 8);
  line.segments.resize(1);
  line.closed = false;
  Layer stroke = outline("a", {line}, 1);
  stroke.paint.line_cap = LineCap::square;
  const Animation animation =
      animate(make_morph(of_layers({stroke}), of_layers({stroke}), options()));
  ASSERT_EQ(animation.layers.size(), 1u);
  EXPECT_TRUE(is_open(animation.layers[0], 0));
  const Contour points = frame_at(animation, 1)[0].contours[0];
  ASSERT_EQ(points.rows(), 33);
  EXPECT_LT((points.row(0) - Eigen::RowVector2d(1, 1)).norm(), rounding);
  EXPECT_LT((points.row(32) - Eigen::RowVector2d(9, 1)).norm(), rounding);
}

// A line there and back encloses an area of rounding errors, of either sign.
TEST(MakeMorph, AnOpenLineIsNoHoleOfASolid) {
  const Drawing solid = of_layers({layer("a", {rectangle(1, 1, 8, 8)}, {1, 0, 0})});
  for (int turn = 0; turn < 32; ++turn) {
    const double angle = 0.2 * turn;
    Subpath line = rectangle(1, 1, 8, 8);
    line.segments.resize(1);
    line.closed = false;
    const Eigen::Vector2d middle(5.1, 4.9), way(3 * std::cos(angle), 3 * std::sin(angle));
    line.segments[0].control << middle - way, middle + way;
    const Drawing stroke = of_layers({outline("a", {line}, 1)});
    for (const bool to_line : {true, false}) {
      const Animation animation = to_line ? animate(make_morph(solid, stroke, options()))
                                          : animate(make_morph(stroke, solid, options()));
      double length = 0;
      for (const FrameLayer& shown : frame_at(animation, to_line ? animation.duration : 0)) {
        if (!shown.paint.stroke || shown.paint.stroke_width == 0) continue;
        for (const Contour& points : shown.contours) {
          length =
              std::max(length, (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm());
        }
      }
      EXPECT_NEAR(length, 6, 1e-6) << "direction " << angle << (to_line ? ", end" : ", start");
    }
  }
}

TEST(MakeMorph, LayersComeIntoTheOrderOfTheEnd) {
  const Layer x = layer("x", {rectangle(1, 1, 6, 6)}, {1, 0, 0}),
              y = layer("y", {rectangle(3, 3, 6, 6)}, {0, 0, 1});
  const Animation animation = animate(make_morph(of_layers({x, y}), of_layers({y, x}), options()));
  check_animation(animation);
  const auto uppermost = [&](double time) { return frame_at(animation, time).back().id; };
  EXPECT_EQ(uppermost(0), "y");
  EXPECT_EQ(uppermost(animation.duration), "x");
  ASSERT_EQ(animation.order.size(), 1u);
}

// Contours that cross each other under the even-odd rule, and a redundant one under the other.
TEST(MakeMorph, DoesNotMatchWhatNoRuleFillsAlike) {
  Layer crossed = layer("a", {rectangle(1, 1, 6, 6), rectangle(3, 3, 6, 6)}, {1, 0, 0});
  crossed.paint.fill_rule = FillRule::evenodd;
  const Layer within = layer("a", {rectangle(1, 1, 8, 8), rectangle(3, 3, 3, 3)}, {1, 0, 0});
  const Layer plain = layer("a", {rectangle(1, 1, 8, 8)}, {1, 0, 0});
  const auto rules = [&](const Layer& to) {
    std::vector<FillRule> found;
    for (const auto& made :
         animate(make_morph(of_layers({crossed}), of_layers({to}), options())).layers) {
      found.push_back(made.paint.front().paint.fill_rule);
    }
    return found;
  };
  EXPECT_EQ(rules(within), (std::vector<FillRule>{FillRule::evenodd, FillRule::nonzero}));
  EXPECT_EQ(rules(plain), std::vector<FillRule>{FillRule::evenodd});
}

TEST(MakeMorph, StartsWhereToldTo) {
  MorphOptions how = options();
  how.starts = {{"face", 5}};
  const Animation animation = animate(make_morph(first(), second(), how));
  const Contour samples = sample_layer(second().layers[0], 64)[0];
  EXPECT_LT((2 * animation.layers[0].outline[1].contours[0].row(0) - samples.row(5)).norm(),
            rounding);
}

TEST(MakeMorph, RefusesWhatDoesNotFit) {
  const auto refuses = [](auto change, const std::string& text) {
    MorphOptions how = options();
    change(how);
    try {
      animate(make_morph(first(), second(), how));
      FAIL() << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  refuses([](MorphOptions& how) { how.samples = 100; }, "100");
  refuses([](MorphOptions& how) { how.scale = 7; }, "7");
  refuses([](MorphOptions& how) { how.map = {{"face", "nose"}}; }, "'nose'");
  refuses([](MorphOptions& how) { how.starts = {{"nose", 1}}; }, "nose=1");
  refuses([](MorphOptions& how) { how.starts = {{"face", 64}}; }, "must be from 0 to 63");
  EXPECT_THROW(make_morph({}, second(), options()), std::invalid_argument);
}

TEST(MakeMorph, RefusesWhatWouldTakeMinutes) {
  const auto refusal = [](const Drawing& from, const Drawing& to, Index samples) -> std::string {
    MorphOptions how = options();
    how.samples = samples;
    try {
      make_morph(from, to, how);
    } catch (const std::logic_error& error) {
      return error.what();
    }
    return "nothing";
  };
  const std::vector<Subpath> few{rectangle(1, 1, 2, 2)}, many(3000, few[0]);
  const Drawing one{{0, 0, 9, 9}, {layer("a", few, {})}},
      crowd{{0, 0, 9, 9}, {layer("a", many, {})}};
  EXPECT_EQ(refusal(crowd, one, 4), "nothing");
  EXPECT_NE(refusal(one, crowd, 1 << 14).find("the destination has 3000 contours"),
            std::string::npos);
  EXPECT_NE(refusal(crowd, crowd, 2048).find("the product is above"), std::string::npos);
  EXPECT_NE(refusal(crowd, crowd, 4).find("3000 and 3000 contours cannot be matched"),
            std::string::npos);
  Drawing layers = one;
  layers.layers.resize(10'001, one.layers[0]);
  EXPECT_NE(refusal(one, layers, 4).find("layers of the destination is 10001"), std::string::npos);
}

}  // namespace
}  // namespace wavecurve::motion
