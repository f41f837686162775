#include "wavecurve/certified/nearest_filter_bank.hpp"

#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/certified/sobolev_exponent.hpp"

namespace wavecurve::certified {

namespace {

Filter<double> nearest(const Filter<Ball>& filter) {
  Filter<double> result{filter.first_index, {}};
  for (const Ball& tap : filter.taps) {
    result.taps.push_back(round_to_double(tap).value_or(tap.to_double()));
  }
  return result;
}

}  // namespace

FilterBank<double> nearest_filter_bank(const FilterDefinition& definition) {
  constexpr long bits = 128;
  const FilterBank<Ball> exact = definition.bank(bits);
  auto bank =
      make_filter_bank(exact.name, nearest(exact.analysis_low), nearest(exact.synthesis_low));
  bank.vanishing_moments = exact.vanishing_moments;
  bank.dual_vanishing_moments = exact.dual_vanishing_moments;
  const Ball exponent = sobolev_exponent(definition);
  bank.sobolev_exponent = exponent.to_double() - exponent.radius_double();
  return bank;
}

}  // namespace wavecurve::certified
