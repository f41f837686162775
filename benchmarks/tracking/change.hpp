#pragma once

#include <string>
#include <string_view>

#include "benchmarks/tracking/bootstrap.hpp"

namespace wavecurve::tracking {

enum class Change { faster, slower, same, inconclusive };
std::string_view to_string(Change verdict);

/// What differs by less is no change, however sure it is.
struct Thresholds {
  double count = 0.01;     ///< of instructions
  double time = 0.05;      ///< of processor time
  double accuracy = 0.10;  ///< of an error
};

/// Judges a time: faster or slower if the interval leaves out 1 and the ratio is beyond the threshold
/// (below 1 / (1 + threshold), above 1 + threshold): both are needed. Same if the whole interval
/// lies within the threshold. Else inconclusive.
Change judge_time(const RatioInterval& ratio, double threshold);

/// Judges a count: slower from 1 + threshold on, faster from 1 / (1 + threshold) down. Ratios are
/// rounded to 1e-4 first: counts repeat to less than half of that where no memory is allocated.
Change judge_count(double before, double after, double threshold);

/// Judges an error, a number of iterations or of digits proved: slower stands for worse. An error is
/// worse from 1 + threshold times itself on, digits are from log10(1 + threshold) fewer on, which
/// is the same; iterations, being counts, by the threshold of counts.
/// Throws std::invalid_argument for another kind.
Change judge_accuracy(const std::string& kind, double before, double after,
                      const Thresholds& thresholds);

}  // namespace wavecurve::tracking
