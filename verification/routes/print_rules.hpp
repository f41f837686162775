#pragma once

#include <vector>

#include "verification/routes/routes.hpp"

namespace wavecurve::verification {

/// The rounding rules that any column may have been printed by, from its true values alone: cut off
/// (toward zero, at the print's own last digit), the nearest doubles or floats printed to however
/// many digits (also in full). Places without a true value are zero.
std::vector<Route> print_rules(const std::vector<TrueValue>& values);

}  // namespace wavecurve::verification
