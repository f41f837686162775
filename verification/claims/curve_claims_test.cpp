// The claims about curves: their verdicts, and that their tables and pictures are whole.
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

TEST(Figure2, StandsInAndShowsTwoGroupsOfFive) {
  const Outcome outcome = outcome_of("figure-2");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::stand_in) << outcome.summary;
  const Picture picture = std::get<Picture>(outcome.evidence.at(0));
  EXPECT_EQ(count(picture.svg, "stroke=\"black\""), 10u);
  for (const char* label : {"(0) 1024", "(3) 128", "(4) 64", "(5) 32", "(6) 16"}) {
    EXPECT_EQ(count(picture.svg, label), 2u) << label;
  }
  expect_full(picture.data);
  expect_full(std::get<Table>(outcome.evidence.at(1)));
}

/// The RMS distance of all three grows from level to level.
TEST(Figure2, HasErrorsThatGrow) {
  const Outcome outcome = outcome_of("figure-2");
  const Table table = std::get<Picture>(outcome.evidence.at(0)).data;
  for (const auto& row : table.rows) {
    for (std::size_t k = 2; k <= 6; ++k) {
      EXPECT_LT(std::stod(row.at(k - 1)), std::stod(row.at(k))) << row[0];
    }
  }
}

TEST(SamplesAsCoefficients, DependsOnTheParameter) {
  const Outcome outcome = outcome_of("samples-as-coefficients");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::depends_on_definition);
  const Table table = std::get<Table>(outcome.evidence.at(0));
  expect_full(table);
  for (const auto& row : table.rows) {
    // The delay adds to the error, but where phi is centred at 0. Printed with four decimals.
    EXPECT_LE(std::stod(row[4]), std::stod(row[2]) + 5e-5) << row[0];
    // Interpolation leaves nothing but rounding, or is refused where the symbol has a zero.
    EXPECT_EQ(row[6], row[0] == "bspline3.3" ? "refused: smallest symbol 0.000" : "below 1e-14");
  }
}

}  // namespace
}  // namespace wavecurve::verification
