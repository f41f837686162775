#include "wavecurve/certified/filter_definition.hpp"

#include <utility>

namespace wavecurve::certified {

FilterDefinition dual(const FilterDefinition& definition) {
  return dual(definition, "dual of " + definition.name);
}

FilterDefinition dual(const FilterDefinition& definition, const std::string& name) {
  FilterDefinition exchanged;
  exchanged.name = name;
  exchanged.known_bits = definition.dual_known_bits;
  exchanged.dual_known_bits = definition.known_bits;
  exchanged.bank = [name, bank = definition.bank](long bits) {
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
