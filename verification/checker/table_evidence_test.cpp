#include "verification/checker/table_evidence.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

CheckedTable table_with(const std::vector<PrintVerdict>& verdicts) {
  CheckedTable table;
  for (const PrintVerdict verdict : verdicts) {
    table.rows.emplace_back().verdict = verdict;
  }
  return table;
}

TEST(TableEvidence, TheWorstNumberDecidesAboutTheTable) {
  using Print = PrintVerdict;
  const auto verdict = [](const std::vector<Print>& verdicts) {
    return verdict_of(table_with(verdicts));
  };
  EXPECT_EQ(verdict({Print::certified, Print::certified}), ClaimVerdict::certified);
  EXPECT_EQ(verdict({Print::certified, Print::form}), ClaimVerdict::form);
  EXPECT_EQ(verdict({Print::form, Print::misprint, Print::published_route}),
            ClaimVerdict::published_route);
  EXPECT_EQ(verdict({Print::certified, Print::misprint}), ClaimVerdict::discrepant);
  EXPECT_EQ(verdict({Print::published_route, Print::undecided}), ClaimVerdict::undecided);
  EXPECT_EQ(verdict({Print::undecided, Print::discrepant}), ClaimVerdict::discrepant);
  EXPECT_EQ(verdict({Print::published_route, Print::agrees_to_digits}), ClaimVerdict::discrepant);
}

TEST(TableEvidence, CountsTheNumbersOfEachVerdict) {
  const Finding finding = count_finding(
      table_with({PrintVerdict::form, PrintVerdict::certified, PrintVerdict::certified}));
  EXPECT_EQ(finding.sentence, "2 certified, 1 form");
  EXPECT_EQ(finding.values, (std::vector<ClaimValue>{counted("certified", 2), counted("form", 1)}));
}

}  // namespace
}  // namespace wavecurve::verification
