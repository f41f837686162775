#include "wavecurve/certified/lifting.hpp"

#include <stdexcept>

#include "wavecurve/certified/diagnostics.hpp"

namespace wavecurve::certified {

namespace {

/// One half of a symmetric sequence, from the middle outwards: the even taps 0, 2, 4, .. from the
/// centre, or the odd ones 1, 3, ..
std::vector<Ball> half(const Filter<Ball>& low, int centre, int parity) {
  std::vector<Ball> result;
  for (int n = centre + parity; n <= low.last_index(); n += 2) result.push_back(low[n]);
  return result;
}

/// longer_k -= s (its two neighbours in shorter), s chosen so that the outermost tap vanishes. Where
/// `even` is the longer one its centre has the two neighbours o_0 and o_{-1} = o_0; an odd tap o_k
/// lies between e_k and e_{k+1}.
Ball take_step(std::vector<Ball>& longer, const std::vector<Ball>& shorter, bool even_is_longer) {
  if (shorter.empty() || shorter.back().contains_zero()) {
    throw std::domain_error("the filter has no lifting steps of two equal taps");
  }
  const Ball s = longer.back() / shorter.back();
  const auto at = [&](std::size_t k) { return k < shorter.size() ? shorter[k] : Ball(0); };
  for (std::size_t k = 0; k < longer.size(); ++k) {
    const Ball left = even_is_longer ? at(k == 0 ? 0 : k - 1) : at(k);
    const Ball right = even_is_longer ? at(k) : at(k + 1);
    longer[k] -= s * (left + right);
  }
  longer.pop_back();
  return s;
}

}  // namespace

LiftingSteps lifting_steps(const FilterDefinition& definition, long bits) {
  const WorkingPrecision precision(bits);
  const Filter<Ball> low = definition.bank(bits).analysis_low;
  if (low.size() % 2 == 0 || symmetry(low) != Symmetry::symmetric) {
    throw std::domain_error("lifting steps are known for symmetric filters of odd length; " +
                            definition.name + " is none");
  }
  const int centre = (low.first_index + low.last_index()) / 2;
  std::vector<Ball> even = half(low, centre, 0), odd = half(low, centre, 1);
  LiftingSteps result;
  while (!odd.empty()) {
    const bool even_is_longer = even.size() > odd.size();
    result.steps.push_back(even_is_longer ? take_step(even, odd, true)
                                          : take_step(odd, even, false));
  }
  if (even.size() != 1)
    throw std::domain_error("the filter has no lifting steps of two equal taps");
  result.factor = even.front();
  return result;
}

}  // namespace wavecurve::certified
