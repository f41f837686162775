#include "verification/suite/run_claims.hpp"

#include <chrono>
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

Outcome holds(std::string own_value) { return {Verdict::holds, std::move(own_value), "", {}}; }

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
    EXPECT_EQ(results[i].outcome.own_value, std::to_string(i));
  }
}

TEST(RunClaims, AClaimThatThrowsIsUndecidedAndStopsNoOther) {
  const std::vector<Claim> suite = {
      claim_with("first", []() -> Outcome { throw std::runtime_error("no root in the box"); }),
      claim_with("second", []() -> Outcome { throw 7; }),
      claim_with("third", [] { return holds("1"); })};
  const auto results = run_claims(suite);
  EXPECT_EQ(results[0].outcome.verdict, Verdict::undecided);
  EXPECT_NE(results[0].outcome.summary.find("no root in the box"), std::string::npos);
  EXPECT_EQ(results[1].outcome.verdict, Verdict::undecided);
  EXPECT_EQ(results[2].outcome.verdict, Verdict::holds);
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
    EXPECT_EQ(result.outcome.verdict, Verdict::holds) << result.outcome.summary;
    EXPECT_EQ(result.outcome.own_value, results.front().outcome.own_value);
  }
}

TEST(RunClaims, NoClaimsNoResults) { EXPECT_TRUE(run_claims({}).empty()); }

}  // namespace
}  // namespace wavecurve::verification
