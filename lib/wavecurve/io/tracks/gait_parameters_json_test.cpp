#include "wavecurve/io/tracks/gait_parameters_json.hpp"

#include <filesystem>
#include <fstream>
#include <optional>
#include <unistd.h>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/files/detail/altered_json_test.hpp"
#include "wavecurve/motion/gait/model/fit_gait.hpp"
#include "wavecurve/motion/gait/record/planted_gait_test.hpp"

namespace wavecurve::io {
namespace {

class GaitParametersFile : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }

  gait::GaitParameters read(const std::string& text) const {
    std::ofstream(path_) << text;  // without a sync for each of thousands
    return read_gait_parameters(path_);
  }

  std::string refusal(const nlohmann::json& document) const {
    try {
      read(document.dump());
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what(), name = path_.string() + ": ";
      EXPECT_EQ(text.substr(0, name.size()), name);
      return text.substr(name.size());
    }
    return "";
  }

  static gait::GaitParameters planted(std::optional<gait::GaitModel> model = std::nullopt) {
    gait::PlantedGait plan;
    plan.points = 16;
    plan.noise = 0.1;
    gait::GaitFitOptions options{find_filter_bank("bspline4.4"), "bspline4.4"};
    options.scale = 8;
    if (model) options.models = {*model};
    return gait::fit_gait(plan.tracks(), options).parameters;
  }

  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / fmt::format("wavecurve_gait_{}.json", ::getpid());
};

TEST_F(GaitParametersFile, IsReadBackAsItWasWritten) {
  for (gait::GaitModel model : gait::gait_models) {
    const gait::GaitParameters parameters = planted(model);
    const std::string text = gait_parameters_json(parameters);
    const gait::GaitParameters back = read(text);
    EXPECT_EQ(gait_parameters_json(back), text) << gait::model_name(model);
    EXPECT_EQ(back.limbs[1].spans[1].start, parameters.limbs[1].spans[1].start);
    EXPECT_EQ(gait::pose_at(back.limbs[2], 0.3), gait::pose_at(parameters.limbs[2], 0.3));
    EXPECT_EQ(gait::pose_at(back.subcycles[1], 0.3), gait::pose_at(parameters.subcycles[1], 0.3));
  }
}

TEST_F(GaitParametersFile, HoldsTheQualityOfEveryLimbPhaseAndModel) {
  const auto document = nlohmann::json::parse(gait_parameters_json(planted()));
  EXPECT_EQ(document["quality"].size(), 4 * 2 * gait::gait_models.size());
  for (const auto& quality : document["quality"]) {
    for (const char* key : {"limb", "phase", "model", "residual_share_of_stride", "cross_validated",
                            "foot_share_of_excursion", "cycles"}) {
      EXPECT_TRUE(quality.contains(key)) << key;
    }
  }
}

TEST_F(GaitParametersFile, WithAnyPlaceAlteredIsReadOrRefusedInOneSentence) {
  const auto documents = altered(nlohmann::json::parse(gait_parameters_json(planted())));
  EXPECT_GT(refused_of(documents, [&](const auto& document) { return refusal(document); }), 500);
}

TEST_F(GaitParametersFile, RefusesWhatItIsNot) {
  const auto good = nlohmann::json::parse(gait_parameters_json(planted()));
  ASSERT_EQ(refusal(good), "");
  auto bad = good;
  bad["format"] = "wavecurve-descriptor";
  EXPECT_EQ(refusal(bad), "\"format\" must be \"wavecurve-gait\"");
  bad = good;
  bad["version"] = 2;
  EXPECT_EQ(refusal(bad), "version is 2, but must be 1");
  bad = good;
  bad["period"] = 0;
  EXPECT_NE(refusal(bad).find("period is 0"), std::string::npos);
  bad = good;
  bad["version"] = 18446744073709551615U;
  EXPECT_EQ(refusal(bad), "version is 18446744073709551615, but must be 1");
  bad = good;
  bad["scale"] = 18446744073709551615U;
  EXPECT_EQ(refusal(bad), "scale is 18446744073709551615, but must be a whole number from 0 to 16");
  bad = good;
  bad["scale"] = 32;
  EXPECT_EQ(refusal(bad), "scale is 32, but must be a whole number from 0 to 16");
  bad = good;
  bad["limbs"][2]["foot"] = 8;
  EXPECT_EQ(refusal(bad), "limbs[2].foot is 8, but must be a whole number from 0 to 7");
  bad = good;
  bad["limbs"][2]["phases"][0]["share"] = 0.9;
  EXPECT_NE(refusal(bad).find("limb LH: the sum of the shares is"), std::string::npos)
      << refusal(bad);
  bad = good;
  bad["limbs"][0]["phases"][0]["x"][3] = nullptr;
  EXPECT_EQ(refusal(bad), "limb LF: limbs[0].phases[0].x[3] is null, but must be a finite number");
  bad = good;
  bad["limbs"][0]["phases"][0]["y"].push_back(1);
  EXPECT_EQ(refusal(bad), "limb LF: limbs[0].phases[0].y is a list of 9, but must be a list of 8");
  bad = good;
  bad["limbs"][1]["phases"][1]["model"] = "straight";
  EXPECT_TRUE(
      refusal(bad).starts_with("limb RF: unknown model 'straight'; known: linear, quadratic, "))
      << refusal(bad);
  bad = good;
  bad["limbs"][1]["phases"][1]["parameters"] = nlohmann::json::array();
  EXPECT_NE(refusal(bad).find("has 0 rows of parameters"), std::string::npos) << refusal(bad);
  bad = good;
  bad.erase("quality");
  EXPECT_NE(refusal(bad).find("the document has no key 'quality'"), std::string::npos);
  bad = good;
  bad["limbs"][0]["phases"].erase(1);
  EXPECT_NE(refusal(bad), "");
}

}  // namespace
}  // namespace wavecurve::io
