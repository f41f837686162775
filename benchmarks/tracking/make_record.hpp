#pragma once

#include "benchmarks/tracking/build.hpp"
#include "benchmarks/tracking/instruction_counts.hpp"
#include "benchmarks/tracking/record.hpp"
#include "benchmarks/tracking/timing.hpp"

namespace wavecurve::tracking {

struct RecordOptions {
  std::string filter = ".";  ///< of the benchmarks that are timed
  int repetitions = 5;       ///< of each
  double seconds = 0.05;     ///< at least, each
  bool is_timed = true;      ///< false: counts and accuracy alone
  bool has_limits = true;    ///< measure what the machine can do
};

/// What can be asked and counted without a clock: environment, valgrind, kernels, accuracy. Empty
/// parts where the build has no marked kernels; without valgrind, no counts.
Json measure_counts(const Build& build, int processes = 3);

/// A whole record, see docs/how-to-read-benchmarks.md.
Json make_record(const Build& build, const RecordOptions& options, const Say& say);

/// Now in UTC, 2026-01-31T12:00:00Z.
std::string date_now();

}  // namespace wavecurve::tracking
