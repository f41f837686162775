// The claims about K and M: their verdicts, and cells that are known from elsewhere.
#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "verification/claims/claim_test.hpp"

namespace wavecurve::verification {
namespace {

std::vector<Table> tables_of(const Outcome& outcome) {
  std::vector<Table> tables;
  for (const Evidence& evidence : outcome.evidence) {
    if (const auto* table = std::get_if<Table>(&evidence)) tables.push_back(*table);
    if (const auto* chart = std::get_if<Chart>(&evidence)) tables.push_back(chart->data);
    if (const auto* picture = std::get_if<Picture>(&evidence)) tables.push_back(picture->data);
  }
  return tables;
}

/// The cell in the row whose first cells are these.
std::string cell(const Table& table, const std::vector<std::string>& first, std::size_t column) {
  for (const auto& row : table.rows) {
    if (std::equal(first.begin(), first.end(), row.begin())) return row.at(column);
  }
  throw std::out_of_range(table.caption);
}

class StiffnessClaims : public testing::TestWithParam<const char*> {};

TEST_P(StiffnessClaims, HaveFullTablesAndTheSameOutcomeTwice) {
  const Outcome outcome = outcome_of(GetParam()), again = outcome_of(GetParam());
  EXPECT_EQ(outcome.finding.sentence, again.finding.sentence);
  EXPECT_FALSE(tables_of(outcome).empty());
  for (const Table& table : tables_of(outcome)) {
    EXPECT_FALSE(table.rows.empty()) << table.caption;
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.caption;
  }
}

INSTANTIATE_TEST_SUITE_P(All, StiffnessClaims,
                         testing::Values("figure-3", "off-diagonal-energy", "sparse",
                                         "diagonally-dominant", "mass-matrix"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(StiffnessClaimsTest, VerdictsFollowFromTheFigures) {
  EXPECT_EQ(outcome_of("figure-3").verdict, ClaimVerdict::holds);
  EXPECT_EQ(outcome_of("off-diagonal-energy").verdict, ClaimVerdict::depends_on_definition);
  EXPECT_EQ(outcome_of("sparse").verdict, ClaimVerdict::depends_on_definition);
  EXPECT_EQ(outcome_of("diagonally-dominant").verdict, ClaimVerdict::does_not_hold);
  EXPECT_EQ(outcome_of("mass-matrix").verdict, ClaimVerdict::depends_on_definition);
}

TEST(StiffnessClaimsTest, OffDiagonalEnergyShowsTheKnownShares) {
  const std::vector<Table> tables = tables_of(outcome_of("off-diagonal-energy"));
  const Table &d8 = tables.at(0), &k2 = tables.at(1), &families = tables.at(2);
  EXPECT_NEAR(std::stod(cell(d8, {"0"}, 1)), 46.3, 0.05);
  EXPECT_EQ(cell(d8, {"1"}, 1), "16.14");
  EXPECT_EQ(cell(d8, {"2"}, 1), "15.19");
  EXPECT_EQ(cell(d8, {"6"}, 1), "15.16");
  EXPECT_EQ(cell(k2, {"1"}, 1), "16.04");
  EXPECT_NEAR(std::stod(cell(d8, {"1"}, 2)), 14.8, 0.05);
  EXPECT_NEAR(std::stod(cell(d8, {"2"}, 2)), 13.8, 0.05);
  EXPECT_NEAR(std::stod(cell(families, {"db10", "6"}, 2)), 14.5, 0.05);
  EXPECT_NEAR(std::stod(cell(families, {"coif1", "6"}, 2)), 18.4, 0.05);
  EXPECT_NEAR(std::stod(cell(families, {"bspline4.4", "6"}, 2)), 45.8, 0.05);
}

TEST(StiffnessClaimsTest, SparseAndDominantShowTheKnownFigures) {
  const Table shares = tables_of(outcome_of("sparse")).at(0);
  EXPECT_NEAR(std::stod(cell(shares, {"db4", "1"}, 4)), 41, 0.5);
  EXPECT_NEAR(std::stod(cell(shares, {"coif2", "2"}, 4)), 83, 0.5);
  EXPECT_NE(outcome_of("diagonally-dominant").finding.sentence.find("32 of 64"), std::string::npos);
}

}  // namespace
}  // namespace wavecurve::verification
