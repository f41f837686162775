#include "verification/suite/run_claims.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

#include "wavecurve/certified/detail/thread_cache.hpp"

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
  std::atomic<std::size_t> next = 0;
  std::size_t finished = 0;
  std::mutex reporting;
  const auto work = [&] {
    const certified::ThreadCache cache;
    for (std::size_t i = next++; i < claims.size(); i = next++) {
      results[i] = {claims[i], evaluate(claims[i])};
      const std::scoped_lock lock(reporting);
      ++finished;
      if (progress) progress(finished, claims.size(), claims[i]);
    }
  };
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> workers;
  for (std::size_t i = 0; i < std::min(cores, claims.size()); ++i) workers.emplace_back(work);
  workers.clear();  // joins
  return results;
}

}  // namespace wavecurve::verification
