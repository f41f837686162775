#pragma once

#include <optional>
#include <string_view>

#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// The biorthogonal B-spline bank "bsplineD.E" of Cohen, Daubechies and Feauveau (1992,
/// section 6.A), D, E >= 1 with D + E even: phi is the B-spline of order D (degree D - 1), centred
/// at 0 or, for odd D, at 1/2; the dual low-pass filter has E zeros at pi. Every tap is an integer
/// times sqrt 2 / 2^k and is rounded correctly by integer arithmetic. Empty for a name of another
/// form; throws std::invalid_argument for orders that spline_orders refuses. Scalar is double or
/// float.
template <class Scalar>
std::optional<FilterBank<Scalar>> spline_filter_bank(std::string_view name);

}  // namespace wavecurve
