#pragma once

#include <vector>

#include "wavecurve/certified/basis_function.hpp"

namespace wavecurve::certified {

/// Values of one function at the dyadic points k / 2^level: element k of the filter is the value
/// there, for every point of the support.
///
/// At the integers they solve the two-scale system (certified/refinable.hpp); each further level
/// follows by f(x) = 2^d sum_k a_k s(2x - k), s the d-th derivative of the scaling function. Exact
/// arithmetic of enclosures: the radius doubles at most with each level and derivative, and the
/// precision is raised until the values have `bits` bits relative to the largest.
///
/// The function must be continuous: its Sobolev exponent has to exceed 1/2 (Sobolev's embedding).
/// That is sufficient; where it fails the values are refused although some function may have them.
/// Throws std::domain_error, naming the exponent, or std::invalid_argument for a derivative outside
/// 0 .. highest_derivative or a level outside 0 .. highest_dyadic_level.
Filter<Ball> dyadic_values(const FilterDefinition& definition, const BasisFunction& f, int level,
                           long bits);

/// A table of a support of 200 at this level has 2 * 10^5 points.
inline constexpr int highest_dyadic_level = 10;

}  // namespace wavecurve::certified
