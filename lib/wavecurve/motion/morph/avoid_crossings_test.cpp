#include "wavecurve/motion/morph/avoid_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/curves/crossings.hpp"
#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/motion/morph/make_morph.hpp"

namespace wavecurve::motion {
namespace {

using Eigen::Index;

const std::vector<double> tenths{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};

Index total(const Morph& morph, const MorphLayer& layer) {
  const auto counts = crossings(morph, layer, tenths);
  return std::accumulate(counts.begin(), counts.end(), Index{0});
}

Drawing drawing(const Contour& points) {
  Layer layer{"shape", {polygon(points)}, {}};
  layer.paint.fill = Colour{};
  return {{0, 0, 10, 10}, {layer}};
}

/// A star of n rays, and a band that winds inwards: their morphs cross at most scales.
Drawing star(int n) {
  Contour points(2 * n, 2);
  for (int i = 0; i < 2 * n; ++i) {
    const double t = std::numbers::pi * i / n, radius = i % 2 == 0 ? 4.5 : 1;
    points.row(i) << 5 + radius * std::sin(t), 5 - radius * std::cos(t);
  }
  return drawing(points);
}

Drawing spiral(double turns) {
  constexpr int half = 200;
  Contour points(2 * half, 2);
  for (int i = 0; i < half; ++i) {
    const double share = i / (half - 1.0), t = 2 * std::numbers::pi * turns * share;
    const double outer = 4.5 - 4 * share, inner = std::max(outer - 1 / turns, 0.1);
    points.row(i) << 5 + outer * std::cos(t), 5 + outer * std::sin(t);
    points.row(2 * half - 1 - i) << 5 + inner * std::cos(t), 5 + inner * std::sin(t);
  }
  return drawing(points);
}

std::vector<Morph> alternatives(const Drawing& a, const Drawing& b, Detail detail, Index samples) {
  MorphOptions options{.bank = find_filter_bank("bspline4.4"), .samples = samples};
  options.detail = detail;
  std::vector<Morph> morphs{make_morph(a, b, options)};
  options.rotation = Rotation::taken_out;
  morphs.push_back(make_morph(a, b, options));
  return morphs;
}

TEST(Crossings, CountsThoseOfTheFrames) {
  const auto morphs = alternatives(spiral(2), star(5), Detail::blend, 256);
  const Animation animation = animate(morphs[0]);
  const auto counts = crossings(morphs[0], morphs[0].layers[0], tenths);
  for (std::size_t i = 0; i < tenths.size(); ++i) {
    const auto frame = frame_at(animation, tenths[i] * animation.duration);
    EXPECT_EQ(counts[i], count_crossings(frame[0].contours));
  }
  EXPECT_GT(std::accumulate(counts.begin(), counts.end(), Index{0}), 0);
}

TEST(Crossings, CountOnceForAStrokeThereAndBack) {
  Subpath loop;
  const double corners[][2] = {{0, 0}, {4, 4}, {4, 0}, {0, 3}};
  for (int i = 0; i < 3; ++i) {
    BezierSegment line;
    line.control.resize(2, 2);
    line.control << corners[i][0], corners[i + 1][0], corners[i][1], corners[i + 1][1];
    loop.segments.push_back(line);
  }
  Layer layer{"loop", {loop}, {}};
  layer.paint.stroke = Colour{};
  const Drawing stroke{{0, 0, 10, 10}, {layer}};
  const Morph morph = alternatives(stroke, stroke, Detail::blend, 64)[0];
  EXPECT_EQ(crossings(morph, morph.layers[0], {0.5}), std::vector<Index>{1});
}

TEST(AvoidCrossings, TakesTheFinestScaleWithoutAny) {
  for (const Detail detail : {Detail::drop, Detail::stage}) {
    const auto morphs = alternatives(spiral(2), star(5), detail, 1024);
    const ChosenMorph chosen = avoid_crossings(morphs, tenths);
    const ScaleChoice& choice = chosen.choices[0];
    EXPECT_EQ(total(chosen.morph, chosen.morph.layers[0]), choice.crossings);
    ASSERT_EQ(choice.crossings, 0);
    EXPECT_EQ(chosen.morph.layers[0].scale, choice.scale);
    for (Morph morph : morphs) {
      morph.stage_share = chosen.morph.stage_share;
      for (MorphLayer layer = morph.layers[0]; layer.scale > choice.scale; layer.scale /= 2) {
        EXPECT_GT(total(morph, layer), 0) << layer.scale;
      }
    }
  }
}

TEST(AvoidCrossings, IsNeverWorseThanFullResolution) {
  for (const double turns : {1.2, 1.5, 3.0}) {
    const auto morphs = alternatives(spiral(turns), star(7), Detail::stage, 128);
    const ChosenMorph chosen = avoid_crossings(morphs, tenths);
    EXPECT_LE(chosen.choices[0].crossings, total(morphs[0], morphs[0].layers[0])) << turns;
  }
}

TEST(AvoidCrossings, NeedsAMorph) {
  EXPECT_THROW(avoid_crossings({}, tenths), std::invalid_argument);
}

/// Animal outlines of the MPEG-7 benchmark, 1024 points each: no crossings, both ends exact.
TEST(AvoidCrossings, WorksForSilhouettes) {
  const std::filesystem::path folder = WAVECURVE_SOURCE_DIR "/../shared/data/silhouettes";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const auto outline = [&](const std::string& name) {
    Contour points(1024, 2);
    std::ifstream file(folder / (name + "-1.csv"));
    std::string text;
    std::getline(file, text);
    for (Index i = 0; i < points.rows(); ++i) {
      char comma;
      file >> points(i, 0) >> comma >> points(i, 1);
    }
    return points;
  };
  for (const auto& [from, to] :
       {std::pair{"dog", "horse"}, {"camel", "elephant"}, {"fish", "bird"}}) {
    const Drawing a = drawing(outline(from)), b = drawing(outline(to));
    const auto morphs = alternatives(a, b, Detail::stage, 1024);
    const ChosenMorph chosen = avoid_crossings(morphs, tenths);
    EXPECT_EQ(chosen.choices[0].crossings, 0) << from;
    const Animation animation = animate(chosen.morph);
    const auto distance = [&](double time, const Drawing& end) {
      // The start may be another one, so the distance is that of each point from the nearest.
      const Contour points = frame_at(animation, time)[0].contours[0];
      const Contour exact = sample_layer(end.layers[0], 1024)[0];
      double largest = 0;
      for (Index i = 0; i < points.rows(); ++i) {
        const double nearest = (exact.rowwise() - points.row(i)).rowwise().norm().minCoeff();
        largest = std::max(largest, nearest);
      }
      return largest;
    };
    // Coordinates up to 700 through two transforms of eight levels.
    EXPECT_LT(distance(0, a), 1e-10) << from;
    EXPECT_LT(distance(animation.duration, b), 1e-10) << from;
  }
}

}  // namespace
}  // namespace wavecurve::motion
