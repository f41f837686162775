
#include <gtest/gtest.h>

#include "verification/claims/claim_test.hpp"

namespace wavecurve::verification {
namespace {

TEST(TableClaims, Table1IsCertified) {
  const Outcome outcome = outcome_of("table-1");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::certified);
  EXPECT_EQ(outcome.finding.sentence, "24 certified");
}

TEST(TableClaims, Table2CameByARoute) {
  const Outcome outcome = outcome_of("table-2");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::published_route);
  EXPECT_EQ(outcome.finding.sentence, "16 certified, 2 form, 5 misprint, 13 published-route");
  const auto* causes = std::get_if<Table>(&outcome.evidence.at(3));
  ASSERT_NE(causes, nullptr);
  EXPECT_EQ(causes->rows.at(0).at(1), "1.000000000011");
  EXPECT_EQ(causes->rows.at(1).at(1), "4.906e-10");
  EXPECT_EQ(causes->rows.at(2).at(1), "8.1e-12");
  EXPECT_EQ(causes->rows.at(3).at(1), "1.1e-10");
  EXPECT_EQ(causes->rows.at(4).at(1), "1.4e-10");
}

TEST(StructureClaims, HoldAsComputed) {
  EXPECT_EQ(outcome_of("support-width").verdict, ClaimVerdict::holds);
  EXPECT_EQ(outcome_of("rank-deficiency").verdict, ClaimVerdict::holds);
  EXPECT_EQ(outcome_of("dropped-equation").verdict, ClaimVerdict::depends_on_definition);
  EXPECT_EQ(outcome_of("scale-condition").verdict, ClaimVerdict::depends_on_definition);
}

}  // namespace
}  // namespace wavecurve::verification
