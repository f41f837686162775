#pragma once

#include <string>

namespace wavecurve::tracking {

/// Why a kernel stays far above its physical limit; "" where it is not known.
std::string limit_reason(const std::string& kernel);

}  // namespace wavecurve::tracking
