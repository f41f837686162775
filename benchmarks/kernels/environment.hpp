#pragma once

#include <nlohmann/json.hpp>

namespace wavecurve::tracking {

/// What a program was built with and runs on, as far as its speed depends on it: compiler, flags,
/// library versions, and the vectors that Highway chooses here.
nlohmann::ordered_json environment();

}  // namespace wavecurve::tracking
