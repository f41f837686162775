#pragma once

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/filters/basis_function.hpp"
#include "wavecurve/filters/filter.hpp"

namespace wavecurve::certified {

using wavecurve::BasisFunction;
using wavecurve::highest_derivative;
using wavecurve::name_of;

/// The two-scale coefficients a_k of a function f, by which
///   f(x) = sum_k a_k s(2x - k),   a_k = sqrt 2 h_k (phi) or sqrt 2 g_k (psi),
/// s being the scaling function of the same side. Derivatives play no part.
Filter<Ball> two_scale_coefficients(const FilterBank<Ball>& bank, const BasisFunction& f);

/// The interval [first, last] outside which the function vanishes.
struct Support {
  double first = 0, last = 0;
};
Support support(const FilterBank<Ball>& bank, const BasisFunction& f);

/// The Sobolev exponent of the function: that of the scaling function of its side, less the order
/// of the derivative.
Ball sobolev_exponent(const FilterDefinition& definition, const BasisFunction& f);

}  // namespace wavecurve::certified
