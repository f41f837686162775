#pragma once

#include <cfloat>

namespace wavecurve::elementary {

static_assert(FLT_EVAL_METHOD == 0, "doubles must be computed as doubles");

/// x + integer_shift is integer_shift plus the integer next to x, |x| < 2^51, and the last bits of
/// the sum are that integer modulo 2^51: rounding and conversion in one addition, with the same
/// result on scalars and on vectors of every kind.
constexpr double integer_shift = 0x1.8p52;

}  // namespace wavecurve::elementary
