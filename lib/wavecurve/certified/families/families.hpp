#pragma once

#include <vector>

#include "wavecurve/certified/families/family.hpp"
#include "wavecurve/certified/polynomial.hpp"

namespace wavecurve::certified {

/// All families, in the order in which they are listed to users.
const std::vector<Family>& families();

}  // namespace wavecurve::certified
