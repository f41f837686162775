#include "wavecurve/io/descriptor_json.hpp"

#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/altered_json_test.hpp"

namespace wavecurve::io {
namespace {

class DescriptorJson : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }

  Descriptor read(const std::string& text) const {
    std::ofstream(path_) << text;  // without a sync for each of thousands
    return read_descriptor(path_);
  }

  void expect_refusal(const std::string& text, const std::string& defect) const {
    try {
      read(text);
      ADD_FAILURE() << defect;
    } catch (const std::invalid_argument& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(path_.string() + ": ")) << message;
      EXPECT_NE(message.find(defect), std::string::npos) << message;
    }
  }

  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() /
      ("wavecurve_descriptor_" + std::to_string(::getpid()) + ".json");
};

/// Doubles of every size, with all of their bits.
Contour random_coefficients(Eigen::Index count) {
  std::mt19937_64 generator;
  Contour result(count, 2);
  for (double& value : result.reshaped()) {
    const double mantissa = static_cast<double>(generator() >> 11) - 0x1p52;
    value = std::ldexp(mantissa, static_cast<int>(generator() % 200) - 150);
  }
  return result;
}

Descriptor example() {
  Descriptor descriptor;
  descriptor.filter = "db4";
  descriptor.options = {64, 3, SampleMode::interpolate, Corners::kept};
  descriptor.view_box = {-1, 0.1, 1.0 / 3, 12};
  LayerDescriptor layer;
  layer.id = "a \"nose\" \\ \n with everything: \xc3\xa4";
  layer.paint.fill = Colour{0.1, 0.2, 1.0 / 3};
  layer.paint.fill_rule = FillRule::evenodd;
  layer.paint.fill_opacity = 0.7;
  layer.contours = {{random_coefficients(64), true, 2.0 / 3},
                    {random_coefficients(64), false, 1e-300}};
  descriptor.layers = {layer, layer};
  descriptor.layers[1].id = "stroke";
  descriptor.layers[1].paint = Paint{};
  descriptor.layers[1].paint.stroke = Colour{1, 0, 1};
  descriptor.layers[1].paint.stroke_width = 0.1;
  return descriptor;
}

void expect_equal(const Descriptor& a, const Descriptor& b) {
  EXPECT_EQ(a.filter, b.filter);
  EXPECT_EQ(a.options.samples, b.options.samples);
  EXPECT_EQ(a.options.levels, b.options.levels);
  EXPECT_EQ(a.options.mode, b.options.mode);
  EXPECT_EQ(a.options.corners, b.options.corners);
  EXPECT_EQ(a.view_box, b.view_box);
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    EXPECT_EQ(a.layers[i].id, b.layers[i].id);
    EXPECT_EQ(a.layers[i].paint, b.layers[i].paint);
    ASSERT_EQ(a.layers[i].contours.size(), b.layers[i].contours.size());
    for (std::size_t k = 0; k < a.layers[i].contours.size(); ++k) {
      const ContourDescriptor &c = a.layers[i].contours[k], &d = b.layers[i].contours[k];
      EXPECT_EQ(c.coefficients, d.coefficients);
      EXPECT_EQ(c.closed, d.closed);
      EXPECT_EQ(c.length, d.length);
    }
  }
}

TEST_F(DescriptorJson, IsReadBackToTheLastBit) {
  const std::string text = descriptor_json(example());
  const Descriptor again = read(text);
  expect_equal(example(), again);
  EXPECT_EQ(descriptor_json(again), text);
}

TEST_F(DescriptorJson, WithAnyPlaceAlteredIsReadOrRefusedInOneSentence) {
  const auto refusal = [&](const nlohmann::json& document) -> std::string {
    try {
      read(document.dump());
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const auto documents = altered(nlohmann::json::parse(descriptor_json(example())));
  EXPECT_GT(refused_of(documents, refusal), 200);
}

TEST_F(DescriptorJson, RefusesWhatIsBroken) {
  const nlohmann::json good = nlohmann::json::parse(descriptor_json(example()));
  const auto with = [&](const char* pointer, const nlohmann::json& value) {
    nlohmann::json changed = good;
    changed[nlohmann::json::json_pointer(pointer)] = value;
    return changed.dump();
  };
  expect_refusal("", "not JSON: it is empty");
  expect_refusal("[]", "\"format\" must be \"wavecurve-descriptor\"");
  expect_refusal("{\"taps\": [1]}", "\"format\" must be \"wavecurve-descriptor\"");
  expect_refusal(with("/version", 2), "version is 2, but must be 1");
  expect_refusal(with("/samples", 65), "samples is 65, but must be a power of two");
  expect_refusal(with("/samples", -4), "samples is -4");
  expect_refusal(with("/samples", 1e30), "samples is 1e+30");
  expect_refusal(with("/samples", 18446744073709551615U), "samples is 18446744073709551615");
  expect_refusal(std::string(100000, '['), "the document is nested more than 100 deep");
  expect_refusal(with("/samples", 32), "contours[0].x is a list of 64, but must be a list of 32");
  expect_refusal(with("/levels", 7), "7");
  expect_refusal(with("/mode", "spline"), "mode is 'spline', but must be samples or interpolate");
  expect_refusal(with("/view_box", {1, 2}), "view_box is a list of 2, but must be a list of 4");
  expect_refusal(with("/layers", nlohmann::json::array()),
                 "layers is a list of 0, but must be a list of at least one layer");
  expect_refusal(with("/layers/1/contours", nlohmann::json::array()),
                 "layers[1].contours is a list of 0");
  expect_refusal(with("/layers/1/contours/0/x/5", nullptr), "layers[1].contours[0].x[5] is null");
  expect_refusal(with("/layers/1/paint/stroke", {0, 1}),
                 "stroke is a list of 2, but must be a list of 3");
  expect_refusal(with("/layers/1/paint/stroke", {0, 1, 2}),
                 "layers[1].paint.stroke[2] is 2, but must be a number from 0 to 1");
  nlohmann::json short_one = good;
  short_one.erase("filter");
  expect_refusal(short_one.dump(), "filter");
}

}  // namespace
}  // namespace wavecurve::io
