#pragma once

#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/filters/user_filter.hpp"

namespace wavecurve::certified {

/// The definition of a user's own filter, after a check of what it claims.
///
/// Decimals that satisfy every relation exactly are exact numbers. Otherwise each tap stands for
/// all numbers that round to it (half a unit of its last digit either way; a bare 0 is exact), and
/// everything computed from it encloses the result for every filter in that box: the radius says
/// what the digits are worth.
///
/// Relations: the sums, biorthonormality at every lag, and the claimed zeros at pi. Throws
/// std::invalid_argument if one is violated by every filter in the box, naming it and by how much;
/// also for an empty filter, more than 1000 taps, indices beyond 10000, a tap that is no decimal,
/// an unknown sum, or a negative claim.
FilterDefinition define_user_filter(const UserFilter& filter);

}  // namespace wavecurve::certified
