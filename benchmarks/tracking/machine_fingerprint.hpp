#pragma once

#include <string>
#include <vector>

#include "benchmarks/tracking/record.hpp"

namespace wavecurve::tracking {

/// What a time depends on besides the program: CPU model, number of processors, caches, kernel,
/// governor; what cannot be read is "unknown".
Json machine_fingerprint();

/// What two records or builds differ in, one "name: was, is" an entry; empty if nothing.
std::vector<std::string> differences(const Json& before, const Json& after);

}  // namespace wavecurve::tracking
