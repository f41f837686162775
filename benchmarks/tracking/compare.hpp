#pragma once

#include <optional>

#include "benchmarks/tracking/build.hpp"
#include "benchmarks/tracking/comparison.hpp"
#include "benchmarks/tracking/timing.hpp"

namespace wavecurve::tracking {

/// What is compared: programs, or a record of what such ones did.
struct Side {
  std::string name;
  std::optional<Build> build;
  Json record;  ///< where there is no build
};

struct CompareOptions {
  Thresholds thresholds;
  bool is_timed = true;        ///< false: counts and accuracy alone
  std::string filter;          ///< of the benchmarks timed; empty: the marked kernels
  int blocks = 12;             ///< A B B A, of each benchmark
  double seconds = 0.01;       ///< at least, of each of the four
  std::uint64_t seed = 1996;   ///< of the order
  bool skip_identical = true;  ///< programs that are byte for byte the same
  bool is_forced = false;      ///< compare what comes from different machines
};

/// Thrown where records of different machines, compilers or libraries are to be compared.
class MachinesDiffer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Counts first; then accuracy; then times, of which those that would raise an alarm are measured
/// once more, and it is raised only if the second measurement says the same by itself. Times of a
/// record are no pairs with any other: they are shown, and same or inconclusive.
/// Throws MachinesDiffer unless is_forced; what the parts throw.
Comparison compare(const Side& a, const Side& b, const CompareOptions& options, const Say& say);

/// The times of these benchmarks of two builds, a row each, in this order.
std::vector<Row> compare_times(const Build& a, const Build& b,
                               const std::vector<BenchmarkName>& benchmarks,
                               const CompareOptions& options, const Say& say);

}  // namespace wavecurve::tracking
