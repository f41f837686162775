#pragma once

#include <string>
#include <vector>

#include "benchmarks/pages/history_series.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::tracking {

// The record on the abscissa, a dotted line where a change point is.

/// The times of a kernel with its limits, in microseconds; `name` is that of its benchmark.
verification::Chart time_chart(const std::string& id, const std::string& kernel,
                               const std::vector<Json>& history,
                               const std::vector<TimesByName>& times, const std::string& name);

/// Its instructions and data references.
verification::Chart count_chart(const std::string& id, const std::string& kernel,
                                const std::vector<Json>& history);

/// Every accuracy of the latest record over its first value: a line each for those that ever
/// differ from it, one for all others.
verification::Chart accuracy_chart(const std::vector<Json>& history);

}  // namespace wavecurve::tracking
