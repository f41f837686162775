#pragma once

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/filters/filter.hpp"

namespace wavecurve::certified {

/// Whether every value has this many bits relative to the largest of them: a value that is nearly
/// zero may be known only absolutely. Compared as balls: as doubles both sides would underflow at
/// about 1000 bits.
bool is_accurate(const Filter<Ball>& values, long bits);

}  // namespace wavecurve::certified
