#pragma once

#include "wavecurve/certified/filter_definition.hpp"

namespace wavecurve::certified {

/// The double nearest to each tap (to the midpoint, where an enclosure is too wide to decide), with
/// the lower end of what is proved of the Sobolev exponent. For the named families find_filter_bank
/// has the same numbers as tables.
FilterBank<double> nearest_filter_bank(const FilterDefinition& definition);

}  // namespace wavecurve::certified
