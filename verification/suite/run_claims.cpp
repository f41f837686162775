#include "verification/suite/run_claims.hpp"

#include <exception>
#include <string>

#include "verification/suite/on_all_cores.hpp"

namespace wavecurve::verification {

namespace {

Outcome failed(const std::string& reason) {
  Outcome outcome;
  outcome.verdict = Verdict::undecided;
  outcome.own_value = "none: the computation failed";
  outcome.summary = "The computation failed: " + reason;
  return outcome;
}

Outcome evaluate(const Claim& claim) {
  try {
    return claim.evaluate();
  } catch (const std::exception& error) {
    return failed(error.what());
  } catch (...) {
    return failed("an error of unknown type");
  }
}

}  // namespace

std::vector<ClaimResult> run_claims(std::span<const Claim> claims, const Progress& progress) {
  std::vector<ClaimResult> results(claims.size());
  std::size_t finished = 0;
  on_all_cores(
      claims.size(),
      [&](std::size_t i) {
        results[i] = {claims[i], evaluate(claims[i])};
      },
      [&](std::size_t i) {
        ++finished;
        if (progress) progress(finished, claims.size(), claims[i]);
      });
  return results;
}

}  // namespace wavecurve::verification
