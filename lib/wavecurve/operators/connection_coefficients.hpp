#pragma once

#include "wavecurve/filters/connection_coefficients.hpp"
#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/operators/two_scale_system.hpp"

namespace wavecurve {

/// In double precision; certified::connection_coefficients gives enclosures.
/// Throws std::domain_error if phi is not smooth enough for the integrals to exist: the Sobolev
/// exponent must exceed (p + q) / 2. Throws std::invalid_argument for p or q outside 0 .. 8.
ConnectionCoefficients<double> connection_coefficients(
    const FilterBank<double>& bank, int p = 1, int q = 1,
    NullVectorMethod method = NullVectorMethod::constrained);

}  // namespace wavecurve
