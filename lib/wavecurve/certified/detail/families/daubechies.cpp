#include <fmt/format.h>

#include "wavecurve/certified/detail/families/family.hpp"
#include "wavecurve/certified/detail/families/halfband_roots.hpp"

namespace wavecurve::certified {

namespace {

constexpr int highest_daubechies_order = 38;

/// The minimum-phase spectral factor: every root of q(x) outside the unit circle, so that the
/// energy of the taps comes first (Daubechies 1988; Ten Lectures, section 6.4).
FilterBank<Ball> minimum_phase_bank(const std::string& name, int order) {
  Polynomial<Ball> low = averaging_polynomial<Ball>(order);
  for (const auto& factor : halfband_factors(order)) low = low * factor;
  return orthonormal_bank(name, {0, low}, order);
}

std::optional<FilterDefinition> define_daubechies(std::string_view name) {
  auto definition = define_by_order("db", name, 1, highest_daubechies_order, minimum_phase_bank);
  if (!definition) return std::nullopt;
  const int order = *number_after("db", name);
  definition->exact = halfband_autocorrelations(order);
  if (order == 1) {  // Haar's taps alone are rational
    const Filter<Rational> low{0, {Rational(1), Rational(1)}};
    definition->two_scale = make_filter_bank(definition->name, low, low);
    definition->two_scale->vanishing_moments = definition->two_scale->dual_vanishing_moments = 1;
  }
  return definition;
}

}  // namespace

Family daubechies_family() {
  Family family{
      "db1-db38 (aliases haar, D2-D76, d2-d76)", {}, {{"haar", "db1"}}, define_daubechies};
  for (int order = 1; order <= highest_daubechies_order; ++order) {
    const std::string name = fmt::format("db{}", order);
    family.members.push_back(name);
    for (const char letter : {'D', 'd'}) {
      family.aliases.emplace_back(fmt::format("{}{}", letter, 2 * order), name);
    }
  }
  return family;
}

}  // namespace wavecurve::certified
