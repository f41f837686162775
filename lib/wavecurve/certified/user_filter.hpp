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
/// Throws std::invalid_argument if a relation (certified/relations.hpp) is violated by every filter
/// in the box, naming the relation and by how much; also for an empty filter, more than 1000 taps,
/// indices beyond 10000, a tap that is no decimal, an unknown sum, or a negative claim.
FilterDefinition define_user_filter(const UserFilter& filter);

}  // namespace wavecurve::certified
