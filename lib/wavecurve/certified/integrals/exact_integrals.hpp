#pragma once

#include <optional>

#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/certified/rational.hpp"
#include "wavecurve/integrals/product_integral.hpp"
#include "wavecurve/integrals/shift_tensor.hpp"

namespace wavecurve::certified {

/// Systems with more unknowns are not solved in fractions: their digits grow with the unknowns.
inline constexpr int most_exact_unknowns = 160;

/// The integrals of certified/integrals/product_integrals.hpp as fractions, where the two-scale
/// coefficients are rational (Haar, splines and their duals, a user's own exact taps) and the
/// system is small enough: it is solved in rational numbers, and so is its rank. Empty otherwise,
/// and for a system that is singular. Throws as product_integrals does for bad input and where the
/// integrals are not proved to exist.
std::optional<ShiftTensor<Rational>> exact_product_integrals(const FilterDefinition& definition,
                                                             const ProductIntegral& integral);

}  // namespace wavecurve::certified
