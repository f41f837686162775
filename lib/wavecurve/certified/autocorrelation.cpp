#include "wavecurve/certified/autocorrelation.hpp"

#include "wavecurve/filters/autocorrelation.hpp"

namespace wavecurve::certified {

Filter<Ball> autocorrelation(const FilterDefinition& definition, long bits) {
  if (definition.exact) {
    const Filter<Rational>& exact = definition.exact->synthesis;
    return {0, {exact.taps.begin(), exact.taps.end()}};
  }
  const FilterBank<Ball> bank = definition.bank(bits);
  Filter<Ball> alpha = wavecurve::autocorrelation(bank.synthesis_low);
  if (bank.is_orthonormal()) {
    alpha.taps[0] = Ball(2);
    for (std::size_t n = 2; n < alpha.taps.size(); n += 2) alpha.taps[n] = Ball(0);
  }
  return alpha;
}

}  // namespace wavecurve::certified
