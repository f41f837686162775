#include "wavecurve/certified/basis_function.hpp"

#include "wavecurve/certified/sobolev_exponent.hpp"

namespace wavecurve::certified {

Filter<Ball> two_scale_coefficients(const FilterBank<Ball>& bank, const BasisFunction& f) {
  Filter<Ball> a = f.wavelet ? (f.dual ? bank.analysis_high : bank.synthesis_high)
                             : (f.dual ? bank.analysis_low : bank.synthesis_low);
  const Ball root_two = sqrt(Ball(2));
  for (Ball& tap : a.taps) tap *= root_two;
  return a;
}

Support support(const FilterBank<Ball>& bank, const BasisFunction& f) {
  const Filter<Ball>& low = f.dual ? bank.analysis_low : bank.synthesis_low;
  if (!f.wavelet) return {double(low.first_index), double(low.last_index())};
  const Filter<Ball>& high = f.dual ? bank.analysis_high : bank.synthesis_high;
  return {0.5 * (high.first_index + low.first_index), 0.5 * (high.last_index() + low.last_index())};
}

Ball sobolev_exponent(const FilterDefinition& definition, const BasisFunction& f) {
  return sobolev_exponent(f.dual ? dual(definition) : definition) - Ball(f.derivative);
}

}  // namespace wavecurve::certified
