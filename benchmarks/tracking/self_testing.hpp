#pragma once

#include <string>
#include <vector>

#include "benchmarks/tracking/build.hpp"
#include "benchmarks/tracking/timing.hpp"

namespace wavecurve::tracking {

/// One thing that the tracking must do: be silent where nothing changed, or find what did.
struct Check {
  std::string what, found;
  bool is_passed = false;
};

/// Tries the tracking on the programs of a build tree and on their copies slowed_100, slowed_20 and
/// slowed_5, in which the kernel transform_forward does its work twice in one of so many runs:
/// - a build against itself, by counts and, in 50 rounds, by times: at most one round may alarm;
/// - the slowed copies against it: 1 % and 5 % found by counts, 20 % by times, nothing else;
/// - the growth of every kernel against the stated one, and that of two twins that are N^2;
/// - accuracies against themselves, and with one worsened.
/// The short form times two kernels with few blocks, else all with as many as `compare`.
/// Without valgrind what counts is left out, and said so.
std::vector<Check> self_test(const Build& build, bool is_short, const Say& say);

}  // namespace wavecurve::tracking
