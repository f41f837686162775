#pragma once

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve::certified {

/// How far the middles of the taps are, on either side.
struct FilterDistance {
  double synthesis, analysis;
};

/// How far the taps in the middle of a bank's enclosures are from the nearest filter that satisfies
/// all its relations F(h) = 0 (detail/relations.hpp), to first order: the largest entries of the
/// shortest step s with F + F' s = 0. Taps that are exactly zero stay so. In double precision, and
/// without proof.
FilterDistance distance_to_exact_filter(const FilterBank<Ball>& bank);

}  // namespace wavecurve::certified
