#pragma once

#include <string>
#include <vector>

#include "benchmarks/tracking/build.hpp"

namespace wavecurve::tracking {

/// A kernel that kernel_benchmark marks.
struct MarkedKernel {
  std::string name;
  long size = 0;            ///< at which it is tracked
  long counted_runs = 1;    ///< runs whose instructions are counted
  bool is_plain = false;    ///< the plain twin of another: its growth is tested, it is not tracked
  std::string growth;       ///< "N" or "N log N", where it states one
  std::vector<long> sizes;  ///< at which that is tested
};

/// What kernel_benchmark answers to --kernels. Throws std::invalid_argument naming the place for an
/// answer that is none, and as ask() does.
std::vector<MarkedKernel> marked_kernels(const Build& build);

}  // namespace wavecurve::tracking
