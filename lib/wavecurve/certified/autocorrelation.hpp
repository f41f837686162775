#pragma once

#include "wavecurve/certified/filter_definition.hpp"

namespace wavecurve::certified {

/// alpha_n of the synthesis low-pass filter (filters/autocorrelation.hpp), n = 0 .. L-1, as
/// enclosures. Values that orthonormality fixes, alpha_0 = 2 and alpha_{2n} = 0, are exact, so that
/// they can be printed; where the definition has exact autocorrelations, all values come from
/// those.
Filter<Ball> autocorrelation(const FilterDefinition& definition, long bits);

}  // namespace wavecurve::certified
