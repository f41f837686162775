// The claims about motion: their verdicts, that their tables are whole, and known figures.
#include <algorithm>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "verification/claims/claim_test.hpp"

namespace wavecurve::verification {
namespace {

/// A cell of a row of numbers.
double number(const Table& table, std::size_t row, std::size_t column) {
  return std::stod(table.rows.at(row).at(column));
}

TEST(DecouplingClaim, DoesNotHoldWithoutStrongStiffnessDamping) {
  const Outcome outcome = outcome_of("decoupling");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::does_not_hold) << outcome.finding.sentence;
  const Table map = std::get<Chart>(outcome.evidence.at(1)).data;
  expect_full(map);
  // Undamped, N = 64: 1.3 to 1.9 for simple shapes, known from elsewhere.
  ASSERT_EQ(map.rows.at(1).at(0), "64");
  ASSERT_EQ(map.rows.at(1).at(1), "none");
  for (std::size_t column = 2; column < 5; ++column) {
    EXPECT_GT(number(map, 1, column), 130);
    EXPECT_LT(number(map, 1, column), 190);
  }
  // Errors vanish as stiffness damping grows: all modes then decay alike, by exp(-t / s_2).
  ASSERT_EQ(map.rows.back().at(1), "s_2 = 10");
  for (std::size_t column = 2; column < 8; ++column) {
    EXPECT_LT(number(map, map.rows.size() - 1, column), 0.1);
  }
}

TEST(DecouplingClaim, ErrorsGrowFromNothing) {
  const Outcome outcome = outcome_of("decoupling");
  const Table by_time = std::get<Chart>(outcome.evidence.at(2)).data;
  expect_full(by_time);
  // Over 10 ^ (1/8) of the time, t^2 grows by 10 ^ (1/4).
  for (std::size_t column = 1; column < 7; ++column) {
    EXPECT_NEAR(number(by_time, 1, column) / number(by_time, 0, column), 1.778, 0.02);
  }
  // With one scale only the diagonal block is the whole matrix.
  const Table levels = std::get<Table>(outcome.evidence.at(3));
  expect_full(levels);
  EXPECT_LT(number(levels, 0, 5), 1e-6);
  expect_full(std::get<Table>(outcome.evidence.at(4)));
  expect_full(std::get<Table>(outcome.evidence.at(5)));
}

TEST(SchulzClaim, Holds) {
  const Outcome outcome = outcome_of("schulz");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::holds) << outcome.finding.sentence;
  expect_full(std::get<Chart>(outcome.evidence.at(0)).data);
  const Table table = std::get<Table>(outcome.evidence.at(1));
  expect_full(table);
  EXPECT_EQ(table.rows.size(), 15u);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    EXPECT_NEAR(number(table, row, 3), 2, 0.1);
    EXPECT_LT(number(table, row, 6), 1e-7);
  }
}

TEST(Figure6, IsRestoredOnlyIfDampedAndNotMoved) {
  const Outcome outcome = outcome_of("figure-6");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::stand_in);
  const Picture picture = std::get<Picture>(outcome.evidence.at(0));
  expect_full(picture.data);
  expect_full(std::get<Chart>(outcome.evidence.at(1)).data);
  EXPECT_NEAR(number(picture.data, 0, 2), 1, 1e-3);  // all frequencies are near multiples of 2 pi
  EXPECT_LT(number(picture.data, 2, 2), 0.01);
  EXPECT_GT(number(picture.data, 3, 1), 0.5);
}

TEST(Figure7, ErrorsFallAndCostsGrowWithTheControlPoints) {
  const Outcome outcome = outcome_of("figure-7");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::stand_in);
  const Table table = std::get<Picture>(outcome.evidence.at(0)).data;
  expect_full(table);
  ASSERT_EQ(table.rows.size(), 5u);
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    EXPECT_LT(number(table, row, 2), number(table, row - 1, 2));
    EXPECT_GT(number(table, row, 3), number(table, row - 1, 3));
    EXPECT_GT(number(table, row, 4), number(table, row - 1, 4));
  }
  EXPECT_EQ(number(table, 4, 2), 0);
}

TEST(EnergyClaim, HoldsForTheExactMotionAndNamesTheDriftOfAllOthers) {
  const Outcome outcome = outcome_of("energy");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::holds) << outcome.finding.sentence;
  const Table curves = std::get<Chart>(outcome.evidence.at(0)).data;
  expect_full(curves);
  double largest = 0;
  for (std::size_t row = 0; row < curves.rows.size(); ++row) {
    EXPECT_EQ(curves.rows[row].at(1), "1.0000");
    largest = std::max(largest, number(curves, row, 2));
  }
  EXPECT_GT(largest, 1.5);  // decoupled
  expect_full(std::get<Table>(outcome.evidence.at(1)));
  const Table drift = std::get<Table>(outcome.evidence.at(2));
  expect_full(drift);
  EXPECT_EQ(drift.rows.front().at(2), "below 1e-13");  // spectral
  EXPECT_GT(number(drift, 1, 2), 0.5);
  EXPECT_GT(number(drift, 1, 3), 0.1);  // damped, and yet it gains
}

TEST(IntegrationOrdersClaim, HoldsForEveryMethod) {
  const Outcome outcome = outcome_of("integration-orders");
  EXPECT_EQ(outcome.verdict, ClaimVerdict::holds) << outcome.finding.sentence;
  expect_full(std::get<Chart>(outcome.evidence.at(0)).data);
  const Table table = std::get<Table>(outcome.evidence.at(1));
  expect_full(table);
  EXPECT_EQ(table.rows.size(), 12u);
  EXPECT_NEAR(number(table, 0, 2), 1, 0.02);  // Euler
  EXPECT_NEAR(number(table, 4, 2), 4, 0.1);   // Runge-Kutta
}

}  // namespace
}  // namespace wavecurve::verification
