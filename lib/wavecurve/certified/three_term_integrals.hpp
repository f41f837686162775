#pragma once

#include <vector>

#include "wavecurve/certified/basis_function.hpp"

namespace wavecurve::certified {

// Three-term connection coefficients of scaling functions, with proof:
//   G(l, m) = int f(x) g(x - l) k(x - m) dx,   f, g, k derivatives of phi or phi~ of orders p, q, r.
//
// With the two-scale coefficients a, b, c of the three and d = p + q + r,
//   G(l, m) = 2^(d-1) sum_{i,j,n} a_i b_j c_n G(2l + j - i, 2m + n - i).                  (R)
// All derivatives of order d obey (R), so that it alone leaves d + 1 solutions. If g and k reproduce
// polynomials up to degree d, sum_l l^i g(x - l) is one of degree i - q with the leading coefficient
// i!/(i-q)!, and integrating by parts gives the d + 1 moments
//   sum_{l,m} l^i m^j G(l, m) = (-1)^p p! i!/(i-q)! j!/(j-r)!,   i + j = d,               (S)
// zero where i < q or j < r. The system solved is (R) plus weights times (S): the integrals satisfy
// it because they satisfy both, and a regular matrix, which the solution proves, has no other
// solution. No equation has to be dropped.

/// G(l, m) for l = first .. last, m = first .. last.
struct ThreeTermIntegrals {
  int first = 0, last = 0;
  std::vector<Ball> values;  ///< row by row in l

  /// Zero where the supports do not meet.
  Ball at(int l, int m) const;
};

/// To this many bits relative to the largest, as far as the definition allows. Throws
/// std::domain_error, naming the exponents, unless the integrals are known to exist (sufficient:
/// two of the three functions square integrable, the third continuous), if g or k reproduces too
/// few degrees, or if there are more than most_three_term_unknowns; std::invalid_argument for a
/// wavelet or a derivative outside 0 .. highest_derivative.
ThreeTermIntegrals three_term_integrals(const FilterDefinition& definition, const BasisFunction& f,
                                        const BasisFunction& g, const BasisFunction& k, long bits);

/// The system is solved by elimination on enclosures, with the cube of the unknowns in time and the
/// square in memory.
inline constexpr int most_three_term_unknowns = 700;

}  // namespace wavecurve::certified
