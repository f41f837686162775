#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "verification/suite/claim.hpp"

namespace wavecurve::verification {

struct ClaimResult {
  Claim claim;
  Outcome outcome;
};

/// Called after each finished claim, never by two threads at once.
using Progress = std::function<void(std::size_t finished, std::size_t total, const Claim& claim)>;

/// Evaluates the claims on all cores; the results stand in the order of the claims. A claim that
/// throws, or whose values are not finite or have the same name, becomes `undecided`, with the
/// error's text in its summary, and stops no other.
std::vector<ClaimResult> run_claims(std::span<const Claim> claims, const Progress& progress = {});

}  // namespace wavecurve::verification
