#pragma once

#include <vector>

#include "wavecurve/certified/filter_definition.hpp"

namespace wavecurve::certified {

/// The lifting steps of a pair with a symmetric analysis low-pass filter of odd length, and the
/// factor that remains: for the 9/7 pair alpha, beta, gamma, delta, zeta (Daubechies and Sweldens
/// 1998, section 7.4), for the 5/3 pair -1/2, 1/4 and its factor.
///
/// With e_k = h_{c+2k}, o_k = h_{c+2k+1} about the centre c of the analysis low-pass filter, the
/// longer of the two loses its ends by one step of Euclid's algorithm,
///   longer_k -= s (shorter_{k-1} + shorter_k),   s the quotient of their end taps,
/// and the steps are listed from the first that a transform applies: predict, update, predict, ...
/// What remains is the constant zeta, with sum h_n = sqrt 2.
struct LiftingSteps {
  std::vector<Ball> steps;
  Ball factor;
};

/// Throws std::domain_error if the filter is not proved symmetric with an odd length, or if a
/// quotient has a divisor that is not proved to differ from zero.
LiftingSteps lifting_steps(const FilterDefinition& definition, long bits);

}  // namespace wavecurve::certified
