#pragma once

#include <vector>

#include "wavecurve/certified/detail/families/family.hpp"
#include "wavecurve/certified/detail/polynomial.hpp"

namespace wavecurve::certified {

/// All families, in the order in which they are listed to users.
const std::vector<Family>& families();

}  // namespace wavecurve::certified
