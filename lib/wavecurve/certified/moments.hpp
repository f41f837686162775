#pragma once

#include <vector>

#include "wavecurve/certified/basis_function.hpp"

namespace wavecurve::certified {

/// The moments int x^p f(x) dx, p = 0 .. highest, of phi, psi, phi~ or psi~, as enclosures of what
/// `bits` bits of the taps give. With m_k = sum_n n^k a_n / 2 of the two-scale coefficients a,
///   M_p (2^p - 1) = sum_{k=1}^p binomial(p, k) m_k M_{p-k},   M_0 = 1         (phi)
///   int x^p psi dx = 2^-p sum_{k=0}^p binomial(p, k) m_k M_{p-k}             (psi),
/// from the two-scale relation under the integral. The moments of psi that vanish by the zeros of
/// the other side's low-pass filter at pi are exactly 0.
/// Throws std::invalid_argument for a derivative, or for highest outside 0 .. highest_moment.
std::vector<Ball> moments(const FilterDefinition& definition, const BasisFunction& f, int highest,
                          long bits);

inline constexpr int highest_moment = 100;

}  // namespace wavecurve::certified
