#include "verification/suite/run_claims.hpp"

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"

namespace wavecurve::verification {
namespace {

Claim claim_with(std::string id, std::function<Outcome()> evaluate) {
  return {std::move(id), "title", "location", "printed", std::move(evaluate)};
}

Outcome holds(const std::string& sentence) { return {ClaimVerdict::holds, {sentence, {}}, "", {}}; }

TEST(RunClaims, ResultsStandInTheOrderOfTheClaimsWhateverTheSpeed) {
  std::vector<Claim> suite;
  for (int i = 0; i < 20; ++i) {
    suite.push_back(claim_with(std::to_string(i), [i] {
      std::this_thread::sleep_for(std::chrono::milliseconds(i % 3));
      return holds(std::to_string(i));
    }));
  }
  const auto results = run_claims(suite);
  ASSERT_EQ(results.size(), suite.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(results[i].claim.id, std::to_string(i));
    EXPECT_EQ(results[i].outcome.finding.sentence, std::to_string(i));
  }
}

TEST(RunClaims, AClaimThatThrowsIsUndecidedAndStopsNoOther) {
  const std::vector<Claim> suite = {
      claim_with("first", []() -> Outcome { throw std::runtime_error("no root in the box"); }),
      claim_with("second", []() -> Outcome { throw 7; }),
      claim_with("third", [] { return holds("1"); })};
  const auto results = run_claims(suite);
  EXPECT_EQ(results[0].outcome.verdict, ClaimVerdict::undecided);
  EXPECT_NE(results[0].outcome.summary.find("no root in the box"), std::string::npos);
  EXPECT_EQ(results[1].outcome.verdict, ClaimVerdict::undecided);
  EXPECT_EQ(results[2].outcome.verdict, ClaimVerdict::holds);
}

TEST(RunClaims, ValuesThatAreNotFiniteOrShareANameMakeAClaimUndecided) {
  const auto with = [](std::vector<ClaimValue> values) {
    return claim_with("id", [values] {
      return Outcome{ClaimVerdict::holds, {"", values}, "", {}};
    });
  };
  const double infinite = std::numeric_limits<double>::infinity();
  const auto results = run_claims(std::vector<Claim>{
      with({to_decimals("stiffness", infinite, 1)}), with({to_digits("order", std::nan(""), 2)}),
      with({counted("rows", 1), counted("rows", 1)}),
      with({counted("rows", 1), counted("entries", 1)})});
  EXPECT_NE(results[0].outcome.summary.find("\"stiffness\" is inf, not a finite"),
            std::string::npos);
  EXPECT_NE(results[1].outcome.summary.find("\"order\" is nan"), std::string::npos);
  EXPECT_NE(results[2].outcome.summary.find("have the name \"rows\""), std::string::npos);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(results[i].outcome.verdict, ClaimVerdict::undecided);
    EXPECT_TRUE(results[i].outcome.finding.values.empty());
  }
  EXPECT_EQ(results[3].outcome.verdict, ClaimVerdict::holds);
}

TEST(RunClaims, ProgressCountsEveryClaimOnceInSteps) {
  const std::vector<Claim> suite(9, claim_with("same", [] { return holds("1"); }));
  std::vector<std::size_t> counts;
  run_claims(suite, [&](std::size_t finished, std::size_t total, const Claim&) {
    EXPECT_EQ(total, 9u);
    counts.push_back(finished);
  });
  EXPECT_EQ(counts, (std::vector<std::size_t>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

/// The leak sanitizer of the preset `sanitize` sees what a thread leaves behind.
TEST(RunClaims, CertifiedComputationsMayRunOnEveryThread) {
  std::vector<Claim> suite;
  for (int i = 0; i < 6; ++i) {
    suite.push_back(claim_with(std::to_string(i), [] {
      const auto bank = certified::find_filter("coif2").bank(256);
      return holds(*certified::round_to_decimals(bank.synthesis_low.taps.front(), 40));
    }));
  }
  const auto results = run_claims(suite);
  for (const ClaimResult& result : results) {
    EXPECT_EQ(result.outcome.verdict, ClaimVerdict::holds) << result.outcome.summary;
    EXPECT_EQ(result.outcome.finding.sentence, results.front().outcome.finding.sentence);
  }
}

TEST(RunClaims, NoClaimsNoResults) { EXPECT_TRUE(run_claims({}).empty()); }

}  // namespace
}  // namespace wavecurve::verification
