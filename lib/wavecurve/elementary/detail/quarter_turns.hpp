#pragma once

#include <cstdint>

namespace wavecurve::elementary {

/// x = quarters pi/2 + angle + low, |angle| <= pi/4 and a little more, |low| at most half a unit of
/// the angle. quarters is modulo 4.
struct QuarterTurns {
  std::uint64_t quarters;
  double angle, low;
};

/// Up to here angles are reduced in doubles, the same on vectors; beyond, in whole numbers.
constexpr double largest_direct_angle = 0x1p20;

/// For finite x. The reduced angle is exact to 2^-63 of itself (the generator proves how near to a
/// multiple of pi/2 a double can be, and what that leaves of the accuracy).
QuarterTurns quarter_turns(double x);

/// Reduction in whole numbers, for |x| >= 2^-10; quarter_turns takes it beyond 2^20.
QuarterTurns quarter_turns_in_whole_numbers(double x);

}  // namespace wavecurve::elementary
