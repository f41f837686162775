#include "wavecurve/io/animations/end_paths.hpp"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/animations/animation_test.hpp"

namespace wavecurve::io {
namespace {

std::string commands(const std::string& path) {
  std::string letters;
  for (const char c : path) {
    if (std::isalpha(static_cast<unsigned char>(c))) letters += c;
  }
  return letters;
}

TEST(EndPaths, HaveEqualCommandsAndTheirPaints) {
  for (const double tolerance : {0.0, 0.02}) {
    OutputOptions options;
    options.tolerance = tolerance;
    const auto json = nlohmann::json::parse(end_paths(sample_animation(), options));
    EXPECT_EQ(json["view_box"], "-10 5 100 80");
    EXPECT_FALSE(json.contains("destination_order"));
    ASSERT_EQ(json["layers"].size(), 3U);
    for (const auto& layer : json["layers"]) {
      EXPECT_EQ(commands(layer["source"]["d"]), commands(layer["destination"]["d"])) << layer["id"];
      EXPECT_EQ(commands(layer["source"]["d"])[1], tolerance > 0 ? 'C' : 'L');
    }
    EXPECT_EQ(json["layers"][0]["source"]["fill"], "#ffcc33");
    EXPECT_EQ(json["layers"][0]["destination"]["fill"], "#4d99ff");
  }
}

TEST(EndPaths, TellWhatIsPaintedInAnotherOrder) {
  const auto json = nlohmann::json::parse(end_paths(exchange_animation()));
  EXPECT_EQ(json["layers"][0]["id"], "red");
  EXPECT_EQ(json["destination_order"], (nlohmann::json{"blue", "red", "line", "gone"}));
}

}  // namespace
}  // namespace wavecurve::io
