#include "wavecurve/certified/filter_definition.hpp"

#include <utility>

namespace wavecurve::certified {

FilterDefinition dual(const FilterDefinition& definition) {
  FilterDefinition exchanged;
  exchanged.name = "dual of " + definition.name;
  exchanged.known_bits = definition.dual_known_bits;
  exchanged.dual_known_bits = definition.known_bits;
  exchanged.bank = [name = exchanged.name, bank = definition.bank](long bits) {
    FilterBank<Ball> b = bank(bits);
    b.name = name;
    std::swap(b.analysis_low, b.synthesis_low);
    std::swap(b.analysis_high, b.synthesis_high);
    std::swap(b.vanishing_moments, b.dual_vanishing_moments);
    return b;
  };
  if (definition.exact) {
    exchanged.exact =
        ExactAutocorrelations{definition.exact->analysis, definition.exact->synthesis};
  }
  return exchanged;
}

}  // namespace wavecurve::certified
