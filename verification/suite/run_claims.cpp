#include "verification/suite/run_claims.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

#include "wavecurve/certified/detail/thread_cache.hpp"

#include "verification/suite/on_all_cores.hpp"

namespace wavecurve::verification {

namespace {

Outcome failed(const std::string& reason) {
  Outcome outcome;
  outcome.verdict = ClaimVerdict::undecided;
  outcome.finding = {"none: the computation failed", {}};
  outcome.summary = "The computation failed: " + reason;
  outcome.failure = reason;
  return outcome;
}

/// Values are told apart by their names, and JSON knows finite numbers only.
void require_sound(const std::vector<ClaimValue>& values) {
  std::set<std::string_view> names;
  for (const ClaimValue& value : values) {
    if (!std::isfinite(value.number)) {
      throw std::domain_error("the value \"" + value.name + "\" is " + value.text() +
                              ", not a finite number");
    }
    if (!names.insert(value.name).second) {
      throw std::invalid_argument("two values have the name \"" + value.name + "\"");
    }
  }
}

Outcome evaluate(const Claim& claim) {
  try {
    Outcome outcome = claim.evaluate();
    require_sound(outcome.finding.values);
    return outcome;
  } catch (const std::bad_alloc&) {  // what the machine lacks says nothing about the claim
    throw;
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
