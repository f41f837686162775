#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "benchmarks/tracking/record.hpp"

namespace wavecurve::tracking {

/// One quantity over the records; not a number where a record does not have it.
using Series = std::vector<double>;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// Below these a series is taken to repeat: counts do to 2e-3 where memory is allocated; medians of
// times on a shared machine to a few percent.
constexpr double noise_of_counts = 1e-3, noise_of_times = 0.02, noise_of_accuracy = 1e-3;

/// The number to which these keys lead, or missing.
double number(const Json& record, const std::vector<std::string>& keys);

/// Processor times of a run in seconds.
struct Times {
  double median, least, largest;
};
using TimesByName = std::map<std::string, Times>;
TimesByName times_of(const Json& record);

/// Indices of the records whose values begin a new level, of the values that are there.
std::vector<std::size_t> changes(const Series& series, double noise);

/// Four digits; ? for what is missing.
std::string cell(double value);

/// The revision of a record, with a + where the working tree had changes.
std::string revision(const Json& record);

}  // namespace wavecurve::tracking
