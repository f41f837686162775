#include "verification/suite/claim_value.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verification/suite/claim_value_json.hpp"

namespace wavecurve::verification {
namespace {

TEST(ClaimValue, IsRoundedToWhatIsShown) {
  EXPECT_EQ(to_decimals("a", 46.3489, 1, "%").number, 46.3);
  EXPECT_EQ(to_decimals("a", 46.3489, 1, "%").text(), "46.3 %");
  EXPECT_EQ(to_decimals("a", 0.2, 3, "s").text(), "0.200 s");
  EXPECT_EQ(to_digits("a", 4.12e-9, 1).number, 4e-9);
  EXPECT_EQ(to_digits("a", 4.12e-9, 1).text(), "4e-09");
  EXPECT_EQ(to_digits("a", 0.0489, 2, "%").text(), "0.049 %");
  EXPECT_EQ(counted("a", 3744).text(), "3744");
  EXPECT_EQ(counted("a", 3, "frames").text(), "3 frames");
  EXPECT_FALSE(std::signbit(to_decimals("a", -0.001, 2).number)) << "-0.00 is not shown";
}

TEST(ClaimValue, HasAToleranceOfHalfAUnitOfTheLastDigit) {
  EXPECT_EQ(counted("a", 3744).tolerance, 0);
  EXPECT_EQ(to_decimals("a", 169.4, 0).tolerance, 0.5);
  EXPECT_EQ(to_decimals("a", 46.3489, 1).tolerance, 0.05);
  EXPECT_EQ(to_decimals("a", 0.2, 4).tolerance, 0.00005);
  EXPECT_EQ(to_digits("a", 0.0489, 2).tolerance, 0.0005);
  EXPECT_EQ(to_digits("a", 0.0999, 2).tolerance, 0.005) << "shown as 0.1, which is 0.10";
  EXPECT_EQ(to_digits("a", 2345, 2).tolerance, 50);
  EXPECT_EQ(to_digits("a", 0, 2).tolerance, 0);
}

TEST(ClaimValue, AgreesWithinTheBlessedToleranceItsEdgesIncluded) {
  const ClaimValue blessed = to_decimals("a", 1, 1).within(0.1, "It scatters.");
  EXPECT_EQ(blessed.reason, "It scatters.");
  for (const double number : {0.9, 1.0, 1.1}) {  // 1.1 - 1 > 0.1 in double
    EXPECT_TRUE(agrees(blessed, to_decimals("a", number, 1))) << number;
  }
  for (const double number : {0.8, 1.2}) {
    EXPECT_FALSE(agrees(blessed, to_decimals("a", number, 1))) << number;
  }
  EXPECT_FALSE(agrees(blessed, to_decimals("a", 1.1001, 4)));
  EXPECT_FALSE(agrees(to_decimals("a", 1, 1), to_decimals("a", 1.2, 1).within(5, "A wish.")))
      << "a wider tolerance has to be blessed first";
}

TEST(ClaimValue, AgreesByDefaultIfItIsShownAlike) {
  EXPECT_TRUE(agrees(to_decimals("a", 46.26, 1), to_decimals("a", 46.34, 1)));
  EXPECT_FALSE(agrees(to_decimals("a", 46.34, 1), to_decimals("a", 46.36, 1)));
  EXPECT_FALSE(agrees(to_digits("a", 0.049, 2), to_digits("a", 0.050, 2)));
  EXPECT_TRUE(agrees(counted("a", 32), counted("a", 32)));
  EXPECT_FALSE(agrees(counted("a", 32), counted("a", 33)));
  EXPECT_FALSE(agrees(counted("a", 32, "%"), counted("a", 32)));
}

TEST(ClaimValue, DoesNotAgreeIfItIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(agrees(to_decimals("a", 1, 1), to_decimals("a", nan, 1)));
  EXPECT_FALSE(
      agrees(to_decimals("a", 1, 1), to_digits("a", std::numeric_limits<double>::infinity(), 1)));
}

TEST(ClaimValue, SurvivesJson) {
  for (const ClaimValue& value :
       {counted("entries", 3744), to_decimals("share", 46.34, 1, "%"),
        to_digits("residual", 4.2e-9, 2).within(1e-8, "Rounding \"errors\".")}) {
    const auto json = nlohmann::json::parse(to_json(value).dump());
    EXPECT_EQ(claim_value_of_json(io::JsonPlace(json)), value) << json.dump();
    for (const char* field : {"name", "number", "unit", "tolerance"}) {
      auto cut = json;
      cut.erase(field);
      EXPECT_THROW(claim_value_of_json(io::JsonPlace(cut)), std::invalid_argument) << field;
    }
  }
  EXPECT_EQ(to_json(counted("entries", 3744)).at("number").dump(), "3744");
  EXPECT_FALSE(to_json(counted("entries", 3744)).contains("reason"));
}

TEST(Finding, MakesItsSentenceFromItsValues) {
  const std::vector<ClaimValue> values = {counted("a", 3), counted("b", 4),
                                          to_decimals("c", 0.5, 1, "%")};
  EXPECT_EQ(Finding("{} of {}; {{x}}", values).sentence, "3 of 4; {x}");
  EXPECT_EQ(Finding("{2} or {0}", values).sentence, "0.5 % or 3");
  EXPECT_EQ(Finding("{}", values).values, values);
  EXPECT_EQ(Finding("no number", {counted("a", 3)}).sentence, "no number");
  EXPECT_THROW(Finding("{} of {}", {counted("a", 3)}), fmt::format_error);
}

}  // namespace
}  // namespace wavecurve::verification
