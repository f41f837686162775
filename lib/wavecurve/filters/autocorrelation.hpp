#pragma once

#include "wavecurve/filters/filter.hpp"

namespace wavecurve {

/// alpha_n = 2 sum_i h_i h_{i+n} for n = 0 .. L-1, L the number of taps; alpha_{-n} = alpha_n.
///
/// For an orthonormal filter alpha_0 = 2 and the other even entries vanish; for the synthesis
/// filter of a biorthogonal pair they do not. Publication, section 3.2, below (3.10).
template <class Scalar>
Filter<Scalar> autocorrelation(const Filter<Scalar>& filter) {
  Filter<Scalar> alpha{0, {}};
  for (int n = 0; n < filter.size(); ++n) {
    Scalar sum(0);
    for (int i = filter.first_index; i + n <= filter.last_index(); ++i) {
      sum += filter[i] * filter[i + n];
    }
    alpha.taps.push_back(sum + sum);
  }
  return alpha;
}

}  // namespace wavecurve
