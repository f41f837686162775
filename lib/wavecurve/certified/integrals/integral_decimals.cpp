#include "wavecurve/certified/integrals/integral_decimals.hpp"

#include <optional>
#include <utility>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/detail/rounded_values.hpp"
#include "wavecurve/certified/integrals/exact_integrals.hpp"
#include "wavecurve/certified/integrals/product_integrals.hpp"

namespace wavecurve::certified {

namespace {

/// The exact integrals of two factors by the filter's autocorrelation, which may be rational where
/// its taps are not.
std::optional<Filter<Rational>> exact_integrals_of_two(const FilterDefinition& definition,
                                                       const ProductIntegral& integral) {
  const auto& [factors, power, interval, period] = integral;
  const bool is_plain = power == 0 && !interval && !period && factors.size() == 2 &&
                        factors[1].shifted && factors[0].level == 0 && factors[1].level == 0;
  if (!is_plain) return std::nullopt;
  const BasisFunction &f = factors[0].function, &g = factors[1].function;
  if (f.dual != g.dual) {
    if (f.derivative + g.derivative > 0) return std::nullopt;
    return Filter<Rational>{0, {Rational(f.wavelet == g.wavelet ? 1 : 0)}};
  }
  if (f.wavelet != g.wavelet) return std::nullopt;
  const auto exact = exact_connection_coefficients(f.dual ? dual(definition) : definition,
                                                   g.derivative, f.derivative);
  if (!exact) return std::nullopt;
  return f.wavelet ? exact->nu : exact->mu;
}

/// The zeros between numbers of one index.
void fill_gaps(std::vector<IntegralDecimal>& entries) {
  for (std::size_t i = 1; i < entries.size(); ++i) {
    const int next = entries[i - 1].indices[0] + 1;
    if (entries[i].indices[0] == next) continue;
    entries.insert(entries.begin() + static_cast<std::ptrdiff_t>(i), {{next}, {"0", "0", "0"}});
  }
}

/// All that is not exactly zero; if nothing is left, the zero at the shifts 0.
template <class Scalar>
std::vector<IntegralDecimal> entries_of(const ShiftTensor<Scalar>& values,
                                        std::vector<DecimalEnclosure> decimals) {
  std::vector<IntegralDecimal> entries;
  for (std::size_t place = 0; place < decimals.size(); ++place) {
    if (decimals[place].exact == "0") continue;
    entries.push_back({values.indices(place), std::move(decimals[place])});
  }
  if (entries.empty()) {
    entries.push_back({std::vector<int>(values.dimensions(), 0), {"0", "0", "0"}});
  }
  if (values.dimensions() == 1) fill_gaps(entries);
  return entries;
}

}  // namespace

std::vector<IntegralDecimal> integral_decimals(const FilterDefinition& definition,
                                               const ProductIntegral& integral, int digits) {
  check_integral(integral);
  if (const auto exact = exact_integrals_of_two(definition, integral)) {
    require_existence(definition, integral);
    std::vector<IntegralDecimal> entries;
    for (int l = exact->first_index; l <= exact->last_index(); ++l) {
      const bool is_end = l == exact->first_index || l == exact->last_index();
      if (is_end && (*exact)[l].is_zero() && exact->size() > 1) continue;
      entries.push_back({{l}, decimal_enclosure((*exact)[l], digits)});
    }
    return entries;
  }
  if (const auto exact = exact_product_integrals(definition, integral)) {
    std::vector<DecimalEnclosure> decimals;
    for (const Rational& value : exact->values) {
      decimals.push_back(decimal_enclosure(value, digits));
    }
    return entries_of(*exact, std::move(decimals));
  }
  ShiftTensor<Ball> values;
  auto decimals = rounded_values(
      [&](long bits) {
        values = product_integrals(definition, integral, bits);
        return values.values;
      },
      digits, definition.known_bits);
  return entries_of(values, std::move(decimals));
}

}  // namespace wavecurve::certified
