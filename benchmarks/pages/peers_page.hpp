#pragma once

#include <filesystem>

#include "benchmarks/tracking/build.hpp"
#include "benchmarks/tracking/timing.hpp"
#include "reports/page.hpp"

namespace wavecurve::tracking {

struct PeersOptions {
  int blocks = 7;         ///< of each pair
  double seconds = 0.02;  ///< at least, of each time
};

/// This library beside its peers on the same work, timed in interleaved processes: the transform
/// (GSL, PyWavelets' compiled core and its calls, a plain loop, memcpy), the digits of filter
/// tables (GSL, PyWavelets), connection coefficients (mpmath), the equation of motion (SUNDIALS,
/// Odeint on the dense matrix), the start-point search and crossings (by the definition).
/// `build` holds all benchmark programs and filter_digits; `root` the Python scripts.
/// Throws std::runtime_error where a program fails.
reports::Page peers_page(const Build& build, const std::filesystem::path& root,
                         const PeersOptions& options, const Say& say);

}  // namespace wavecurve::tracking
