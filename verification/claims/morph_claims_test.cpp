// The claims about morphing: their verdicts, and that their tables and pictures are whole.
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "verification/claims/claim_test.hpp"

namespace wavecurve::verification {
namespace {

TEST(Figure4, ShowsTwelveFramesOfAllLayers) {
  const Outcome outcome = outcome_of("figure-4");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::stand_in);
  const Picture picture = std::get<Picture>(outcome.evidence.at(0));
  EXPECT_NE(picture.svg.find("12 frames"), std::string::npos);
  EXPECT_LT(picture.svg.size(), 1000000u);  // a page holds it
  expect_full(picture.data);
}

TEST(Figure5, SetsPhysicalMotionsBesideTheLinearOne) {
  const Outcome outcome = outcome_of("figure-5");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::stand_in);
  const Picture picture = std::get<Picture>(outcome.evidence.at(0));
  EXPECT_NE(picture.svg.find("12 frames"), std::string::npos);
  EXPECT_LT(picture.svg.size(), 2000000u);
  expect_full(picture.data);
  ASSERT_EQ(picture.data.rows.size(), 4u);
  // The linear one never swings over; the lively one does, and has settled.
  EXPECT_EQ(picture.data.rows.at(0).at(5), "0");
  EXPECT_GT(std::stod(picture.data.rows.at(1).at(5)), 0.1);
  EXPECT_LE(std::stod(picture.data.rows.at(1).at(7)), 0.002);
}

TEST(CrossingsClaim, DoesNotHoldWithoutCondition) {
  const Outcome outcome = outcome_of("crossings");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::does_not_hold) << outcome.finding.sentence;
  const Table table = std::get<Table>(outcome.evidence.at(1));
  expect_full(table);
  // Faces never cross; the spiral that becomes a star does, but not with four control points.
  EXPECT_EQ(table.rows.at(0).at(2), "0");
  EXPECT_NE(table.rows.at(4).at(2), "0");
  EXPECT_EQ(table.rows.at(4).at(10), "0");
}

}  // namespace
}  // namespace wavecurve::verification
