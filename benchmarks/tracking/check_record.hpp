#pragma once

#include "benchmarks/tracking/record.hpp"

namespace wavecurve::tracking {

/// Throws std::invalid_argument with one sentence that names the place, "kernels.gram.size is null,
/// but must be ...", unless all that this version reads of a record is there as it must be; what it
/// does not know may be anything. After this, no reader of the record need look again.
void check_record(const Json& record);

}  // namespace wavecurve::tracking
