// The claims about the gait: that they stand in, and that their pictures and tables say what they
// are for.
#include <cstdlib>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "verification/claims/claim_test.hpp"

namespace wavecurve::verification {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

double number(const Table& table, std::size_t row, std::size_t column) {
  return std::strtod(table.rows.at(row).at(column).c_str(), nullptr);
}

Picture picture_of(const Outcome& outcome) { return std::get<Picture>(outcome.evidence.at(0)); }

class GaitFigure : public testing::TestWithParam<std::string> {};

TEST_P(GaitFigure, StandsInNamesItsDataAndHasFullTables) {
  const Outcome outcome = outcome_of(GetParam());
  EXPECT_EQ(outcome.verdict, ClaimVerdict::stand_in);
  EXPECT_NE(outcome.summary.find("dog"), std::string::npos);
  for (const Evidence& evidence : outcome.evidence) {
    if (const auto* picture = std::get_if<Picture>(&evidence)) expect_full(picture->data);
    if (const auto* chart = std::get_if<Chart>(&evidence)) expect_full(chart->data);
    if (const auto* table = std::get_if<Table>(&evidence)) expect_full(*table);
  }
}

INSTANTIATE_TEST_SUITE_P(Figures, GaitFigure,
                         testing::Values("figure-8", "figure-9", "figure-10", "figure-11",
                                         "figure-12", "figure-13", "figure-14"),
                         [](const auto& figure) {
                           return "figure_" + figure.param.substr(figure.param.find('-') + 1);
                         });

TEST(Figure9, RecordAndModelStandWhenPublished) {
  const Outcome outcome = outcome_of("figure-9");
  const Table table = picture_of(outcome).data;
  ASSERT_EQ(table.rows.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const double published = number(table, i, 1);
    // Feet touch down with the speed of the ground, the same for all limbs: only the resolution of
    // 1/32 of a cycle is left, and of the model its error.
    EXPECT_NEAR(number(table, i, 2), published, 1.0 / 32);
    EXPECT_NEAR(number(table, i, 3), published, 1.0 / 32);
  }
}

TEST(Figure10, HasAllFramesAndBothKeyFramesOfFourLimbs) {
  const Picture picture = picture_of(outcome_of("figure-10"));
  const auto frames = static_cast<std::size_t>(number(picture.data, 0, 1));
  EXPECT_GE(frames, 7u);
  // One of each in the legend.
  EXPECT_EQ(count(picture.svg, "stroke-dasharray=\"0.1 2\""), 4 * frames + 1);
  EXPECT_EQ(count(picture.svg, "stroke-dasharray=\"5 3\""), 5u);
}

TEST(Figure11, TheCubicFollowsTheSwingAndTheQuadraticDoesNot) {
  const Outcome outcome = outcome_of("figure-11");
  const Table table = std::get<Table>(outcome.evidence.at(4));
  double quadratic = 0, cubic = 1;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.rows[row][1] != "swing") continue;
    if (table.rows[row][2] == "quadratic") quadratic = number(table, row, 3);
    if (table.rows[row][2] == "cubic") cubic = number(table, row, 3);
  }
  EXPECT_GT(quadratic, 3 * cubic);
}

TEST(Figure11, CurvesPassThroughBothKeyFrames) {
  const Outcome outcome = outcome_of("figure-11");
  const Table table = std::get<Chart>(outcome.evidence.at(0)).data;
  for (std::size_t column = 3; column < table.columns.size(); ++column) {
    EXPECT_NEAR(number(table, 0, column), 1, 1e-4) << table.columns[column];
    EXPECT_NEAR(number(table, 40, column), 0, 1e-4) << table.columns[column];
  }
}

TEST(Figure12, HasFourSubcyclesOfSixFramesOnTheGround) {
  const Picture picture = picture_of(outcome_of("figure-12"));
  EXPECT_EQ(count(picture.svg, "viewBox=\"0 0 360 260\""), 24u);
  for (const char* label : {">A<", ">B<", ">C<", ">D<"}) EXPECT_EQ(count(picture.svg, label), 1u);
  EXPECT_LE(number(picture.data, 0, 2), 2);  // % of the stride
}

TEST(Figure14, ErrorsFallWithTheControlPoints) {
  const Picture picture = picture_of(outcome_of("figure-14"));
  EXPECT_EQ(count(picture.svg, "viewBox=\"0 0 360 260\""), 18u);
  ASSERT_EQ(picture.data.rows.size(), 3u);
  for (std::size_t row : {1u, 2u}) {
    for (std::size_t column : {1u, 2u}) {
      EXPECT_LT(number(picture.data, row, column), number(picture.data, row - 1, column));
    }
  }
}

}  // namespace
}  // namespace wavecurve::verification
