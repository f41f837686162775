#pragma once

#include <algorithm>
#include <optional>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/detail/refine.hpp"
#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/filters/filter.hpp"

namespace wavecurve::certified {

/// Whether every value has this many bits relative to the largest of them: a value that is nearly
/// zero may be known only absolutely. Compared as balls: as doubles both sides would underflow at
/// about 1000 bits.
bool is_accurate(const Filter<Ball>& values, long bits);

/// compute(bank) at rising precision until the values are accurate to this many bits, or to what the
/// taps tell: where those of both sides are decimals, no more precision than theirs is tried.
template <class Compute>
Filter<Ball> accurate_values(const FilterDefinition& definition, long bits, Compute compute) {
  constexpr long guard_bits = 64;
  std::optional<long> known;
  if (definition.known_bits && definition.dual_known_bits) {
    known = std::max(*definition.known_bits, *definition.dual_known_bits);
  }
  Filter<Ball> values;
  const auto attempt = [&](long working) {
    values = compute(definition.bank(working));
    return is_accurate(values, bits);
  };
  refine((known ? std::min(bits, *known) : bits) + guard_bits, attempt, known);
  return values;
}

}  // namespace wavecurve::certified
