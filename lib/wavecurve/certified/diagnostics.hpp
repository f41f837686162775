#pragma once

#include <optional>
#include <utility>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/filter_definition.hpp"

namespace wavecurve::certified {

/// The constants A, B with A |c|^2 <= |sum_l c_l phi(x - l)|^2 <= B |c|^2 for every sequence c.
struct RieszBounds {
  Ball lower, upper;
};

/// The extremes of the Gram symbol G(w) = sum_l (int phi(x - l) phi(x) dx) cos(l w) on 0 <= w <=
/// pi, by interval branch and bound to a relative width of 1e-10, or as far as the taps are known.
/// Exactly 1 and 1 for an orthonormal family, whose shifts are orthonormal if the taps are and the
/// exponent of sobolev_exponent.hpp is positive (Lawton 1991). Empty where the bounds do not exist,
/// phi being not square integrable, or the lower one is not proved positive.
std::optional<RieszBounds> riesz_bounds(const FilterDefinition& definition);

enum class Symmetry { symmetric, antisymmetric, none };

/// The symmetry of the taps about their middle: none if proved so; else symmetric to within the enclosures at
/// the given precision.
Symmetry symmetry(const Filter<Ball>& filter);

/// The interval outside which psi vanishes, from the supports [first, last] of phi and of the taps.
std::pair<double, double> wavelet_support(const FilterBank<Ball>& bank);

}  // namespace wavecurve::certified
