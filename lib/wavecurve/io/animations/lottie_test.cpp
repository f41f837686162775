#include "wavecurve/io/animations/lottie.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <rlottie_capi.h>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/animations/animation_test.hpp"
#include "wavecurve/io/animations/detail/raster.hpp"

namespace wavecurve::io {
namespace {

using Json = nlohmann::json;

OutputOptions options_with(double tolerance) {
  OutputOptions options;
  options.frames = 61;
  options.pixels = 500;
  options.tolerance = tolerance;
  return options;
}

/// The items of a layer's group that are of a type.
std::vector<Json> items(const Json& layer, const std::string& type) {
  std::vector<Json> result;
  for (const Json& item : layer["shapes"][0]["it"]) {
    if (item["ty"] == type) result.push_back(item);
  }
  return result;
}

/// What a player paints on white paper: 255 minus red, green and blue, pixel by pixel.
using Ink = std::vector<double>;

Ink ink_of(const Raster& raster) {
  Ink ink;
  for (std::size_t i = 0; i < raster.rgba.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) {
      ink.push_back(raster.rgba[i + 3] / 255.0 * (255 - raster.rgba[i + c]));
    }
  }
  return ink;
}

Ink rlottie_ink(const std::string& json, std::size_t frame, std::size_t width, std::size_t height) {
  const std::unique_ptr<Lottie_Animation, decltype(&lottie_animation_destroy)> animation(
      lottie_animation_from_data(json.c_str(),
                                 std::to_string(std::hash<std::string>{}(json)).c_str(), ""),
      &lottie_animation_destroy);
  if (!animation) throw std::runtime_error("rlottie does not read this");
  EXPECT_EQ(lottie_animation_get_totalframe(animation.get()), 61U);
  EXPECT_NEAR(lottie_animation_get_framerate(animation.get()), 30, 1e-6);
  std::vector<std::uint32_t> pixels(width * height);
  lottie_animation_render(animation.get(), frame, pixels.data(), width, height, 4 * width);
  Ink ink;
  for (const std::uint32_t pixel : pixels) {  // components are multiplied by the opacity
    const double alpha = pixel >> 24;
    for (int shift : {16, 8, 0}) ink.push_back(alpha - (pixel >> shift & 255));
  }
  return ink;
}

double intersection_over_union(const Ink& a, const Ink& b) {
  EXPECT_EQ(a.size(), b.size());
  double lesser = 0, greater = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    lesser += std::min(a[i], b[i]);
    greater += std::max(a[i], b[i]);
  }
  return lesser / greater;
}

TEST(Lottie, RlottieShowsWhatOurRasterShows) {
  for (const motion::Animation& animation : {sample_animation(), exchange_animation()}) {
    for (double tolerance : {0.0, 0.02}) {
      const std::string json = lottie(animation, options_with(tolerance));
      for (int quarter = 0; quarter <= 4; ++quarter) {
        const auto frame = static_cast<std::size_t>(15 * quarter);
        const Raster own =
            render(motion::frame_at(animation, quarter / 2.0), animation.view_box, {500, 400});
        const double overlap =
            intersection_over_union(rlottie_ink(json, frame, 500, 400), ink_of(own));
        EXPECT_GE(overlap, 0.99) << "tolerance " << tolerance << ", frame " << frame;
        RecordProperty("overlap", std::to_string(overlap));
      }
    }
  }
}

TEST(Lottie, ShowsExchangedLayersByTurns) {
  const Json json = Json::parse(lottie(exchange_animation(), options_with(0)));
  std::vector<std::string> names;
  for (const Json& layer : json["layers"]) names.push_back(layer["nm"]);
  EXPECT_EQ(names, (std::vector<std::string>{"gone", "line", "blue", "red", "blue"}));
  const Json& first = json["layers"][2]["ks"]["o"]["k"];
  EXPECT_EQ(first[0]["s"], Json({100}));
  EXPECT_EQ(first[1]["t"], 30);
  EXPECT_EQ(first[1]["s"], Json({0}));
  EXPECT_EQ(first[1]["h"], 1);
  EXPECT_EQ(json["layers"][4]["ks"]["o"]["k"][0]["s"], Json({0}));
  const Json& line = json["layers"][1];
  EXPECT_EQ(line["shapes"].size(), 2U);  // a group for each cap
  EXPECT_EQ(items(line, "st")[0]["lc"], 3);
  EXPECT_EQ(items(line, "sh")[0]["ks"]["k"][0]["s"][0]["c"], false);
}

TEST(Lottie, LinearMotionHasTwoKeysAndWhatRestsHasNone) {
  const Json json = Json::parse(lottie(sample_animation(), options_with(0.02)));
  EXPECT_EQ(json["op"], 61);
  EXPECT_EQ(json["fr"], 30);
  EXPECT_EQ(json["w"], 500);
  EXPECT_EQ(json["h"], 400);
  ASSERT_EQ(json["layers"].size(), 3U);
  const Json& ring = json["layers"][1];
  EXPECT_EQ(ring["nm"], "<ring> & \"hole\"");
  ASSERT_EQ(items(ring, "sh").size(), 2U);
  for (const Json& shape : items(ring, "sh")) EXPECT_EQ(shape["ks"]["k"].size(), 2U);
  EXPECT_EQ(items(ring, "fl")[0]["c"]["a"], 0);
  EXPECT_EQ(items(ring, "fl")[0]["r"], 2);
  EXPECT_EQ(items(ring, "fl")[0]["o"]["k"][1]["s"], Json({50}));
  const Json& line = json["layers"][0];  // the uppermost comes first
  EXPECT_EQ(items(line, "fl").size(), 0U);
  EXPECT_EQ(items(line, "st")[0]["w"]["k"], 15);
  EXPECT_EQ(items(line, "sh")[0]["ks"]["k"][0]["t"], 15);
}

TEST(Lottie, AllKeysOfAShapeHaveTheSameNumberOfVertices) {
  for (double tolerance : {0.0, 0.5, 0.001}) {
    const Json json = Json::parse(lottie(sample_animation(), options_with(tolerance)));
    for (const Json& layer : json["layers"]) {
      for (const Json& shape : items(layer, "sh")) {
        const std::size_t vertices = shape["ks"]["k"][0]["s"][0]["v"].size();
        for (const Json& key : shape["ks"]["k"]) {
          for (const char* part : {"v", "i", "o"}) {
            EXPECT_EQ(key["s"][0][part].size(), vertices) << layer["nm"];
          }
        }
      }
    }
  }
}

TEST(Lottie, VerticesAreThePointsToTheStatedAccuracy) {
  const motion::Animation animation = sample_animation();
  const Json json = Json::parse(lottie(animation, options_with(0)));
  const Contour& points = animation.layers[0].outline[1].contours[0];
  const Json vertices = items(json["layers"][2], "sh")[0]["ks"]["k"][1]["s"][0]["v"];
  ASSERT_EQ(vertices.size(), 256U);
  // 1e-4 of 500 pixels asks for two places, so half of 0.01 is the largest rounding.
  for (Eigen::Index i = 0; i < 256; ++i) {
    const Json& vertex = vertices[static_cast<std::size_t>(i)];
    EXPECT_NEAR(vertex[0].get<double>(), 5 * (points(i, 0) + 10), 0.005 + 1e-9);
    EXPECT_NEAR(vertex[1].get<double>(), 5 * (points(i, 1) - 5), 0.005 + 1e-9);
  }
}

/// Points of the cubics of a shape at a time in frames, as a player mixes its keys.
Contour lottie_points(const Json& property, double frame) {
  const Json& keys = property["k"];
  std::size_t next = 1;
  while (next + 1 < keys.size() && keys[next]["t"].get<double>() < frame) ++next;
  const double from = keys[next - 1]["t"], to = keys[next]["t"];
  const double share = std::clamp((frame - from) / (to - from), 0.0, 1.0);
  const auto value = [&](const char* part, std::size_t i) {
    const Json &a = keys[next - 1]["s"][0][part][i], &b = keys[next]["s"][0][part][i];
    return Eigen::RowVector2d(std::lerp(a[0].get<double>(), b[0].get<double>(), share),
                              std::lerp(a[1].get<double>(), b[1].get<double>(), share));
  };
  constexpr int steps = 200;
  const std::size_t count = keys[0]["s"][0]["v"].size();
  Contour points(static_cast<Eigen::Index>(count) * steps, 2);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = (i + 1) % count;
    const Eigen::RowVector2d start = value("v", i), end = value("v", j);
    const Eigen::RowVector2d after = start + value("o", i), before = end + value("i", j);
    for (int k = 0; k < steps; ++k) {
      const double s = static_cast<double>(k) / steps, r = 1 - s;
      points.row(static_cast<Eigen::Index>(i) * steps + k) =
          r * r * r * start + 3 * r * r * s * after + 3 * r * s * s * before + s * s * s * end;
    }
  }
  return points;
}

/// A circle that swings out, comes to rest and stays: 101 keys in two seconds.
motion::Animation swinging() {
  motion::Animation animation{{0, 0, 100, 100}, 2, {{"l", {}, {{0, filled(0, 0, 0)}}}}};
  for (int k = 0; k <= 100; ++k) {
    const double t = k / 50.0, swing = std::exp(-4 * t) * std::cos(8 * t);
    animation.layers[0].outline.push_back(
        {t, {flower(50 + 20 * swing, 50, 20, 128, 0.3 * swing, 3)}});
  }
  return animation;
}

TEST(Lottie, FittedKeysKeepTheToleranceAtAllTimes) {
  const motion::Animation animation = swinging();
  for (const double tolerance : {0.02, 0.1, 1.0}) {
    const Json json = Json::parse(lottie(animation, options_with(tolerance)));
    const Json property = items(json["layers"][0], "sh")[0]["ks"];
    EXPECT_LT(property["k"].size(), tolerance < 0.1 ? 80U : 50U);
    for (int i = 0; i <= 300; ++i) {
      const double time = i / 150.0;
      const Contour exact = motion::frame_at(animation, time)[0].contours[0] * 5;
      const Contour written = lottie_points(property, 30 * time);
      double farthest = 0, step = 0;
      for (Eigen::Index row = 0; row < exact.rows(); ++row) {
        farthest =
            std::max(farthest, (written.rowwise() - exact.row(row)).rowwise().norm().minCoeff());
      }
      for (Eigen::Index row = 1; row < written.rows(); ++row) {
        step = std::max(step, (written.row(row) - written.row(row - 1)).norm());
      }
      // Vertices and handles are each rounded by 0.005, and the nearest point may lie between two.
      ASSERT_LE(farthest, 5 * tolerance + 0.01 * std::sqrt(2.0) + step / 2)
          << tolerance << " at " << time;
    }
  }
  EXPECT_EQ(items(Json::parse(lottie(animation, options_with(0)))["layers"][0], "sh")[0]["ks"]["k"]
                .size(),
            101U);
}

TEST(Lottie, HasASizeAndABackground) {
  OutputOptions options = options_with(0);
  options.size = RasterSize{300, 160};
  options.background = Colour{1, 0, 0};
  const Json json = Json::parse(lottie(sample_animation(), options));
  EXPECT_EQ(json["w"], 300);
  EXPECT_EQ(json["h"], 160);
  ASSERT_EQ(json["layers"].size(), 4U);
  const Json& ground = json["layers"][3];
  EXPECT_EQ(ground["ty"], 1);
  EXPECT_EQ(ground["sc"], "#ff0000");
  EXPECT_EQ(ground["sw"], 300);
  // The drawing of 100 by 80 stands in the middle, 200 pixels wide.
  const Json vertex = items(json["layers"][2], "sh")[0]["ks"]["k"][0]["s"][0]["v"][0];
  EXPECT_NEAR(vertex[0].get<double>(), 50 + 2 * (70 + 10), 0.05);
}

TEST(Lottie, RefusesUnequalVertexCountsAndNamesTheLayer) {
  motion::Animation animation = sample_animation();
  animation.layers[1].outline[1].contours[1] = flower(0, 0, 1, 63);
  for (double tolerance : {0.0, 0.02}) {
    try {
      lottie(animation, options_with(tolerance));
      FAIL();
    } catch (const std::invalid_argument& error) {
      EXPECT_STREQ(error.what(),
                   "layer '<ring> & \"hole\"': contour 1 has 64 points in key 0 and 63 in key 1");
    }
  }
  OutputOptions one;
  one.frames = 1;
  EXPECT_THROW(lottie(sample_animation(), one), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::io
