#include "wavecurve/certified/filter_definition.hpp"

#include <utility>

namespace wavecurve::certified {

namespace {

template <class Scalar>
FilterBank<Scalar> exchanged_sides(FilterBank<Scalar> bank, const std::string& name) {
  bank.name = name;
  std::swap(bank.analysis_low, bank.synthesis_low);
  std::swap(bank.analysis_high, bank.synthesis_high);
  std::swap(bank.vanishing_moments, bank.dual_vanishing_moments);
  return bank;
}

}  // namespace

FilterDefinition dual(const FilterDefinition& definition) {
  return dual(definition, "dual of " + definition.name);
}

FilterDefinition dual(const FilterDefinition& definition, const std::string& name) {
  FilterDefinition exchanged;
  exchanged.name = name;
  exchanged.known_bits = definition.dual_known_bits;
  exchanged.dual_known_bits = definition.known_bits;
  exchanged.bank = [name, bank = definition.bank](long bits) {
    return exchanged_sides(bank(bits), name);
  };
  if (definition.exact) {
    exchanged.exact =
        ExactAutocorrelations{definition.exact->analysis, definition.exact->synthesis};
  }
  if (definition.two_scale) exchanged.two_scale = exchanged_sides(*definition.two_scale, name);
  return exchanged;
}

}  // namespace wavecurve::certified
