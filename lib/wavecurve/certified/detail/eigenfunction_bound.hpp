#pragma once

#include <optional>
#include <vector>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/filters/square_matrix.hpp"

namespace wavecurve::certified {

// The spectral radius of an operator T on even trigonometric polynomials
//   u(w) = u_0 + 2 sum_{0 < k < n} u_k cos(k w)
// that maps non-negative ones to such, by an approximate eigenfunction. Where u > 0 everywhere and
//   m u <= T u <= M u   (as functions),
// every v obeys -C u <= v <= C u for some C, so that -C M^k u <= T^k v <= C M^k u and T^k u >= m^k u:
//   m <= rho <= M   (Collatz and Wielandt).
// With the residual r = T u - lambda u, |r(w)| <= R = |r_0| + 2 sum |r_k|, and u >= c > 0:
//   |rho - lambda| <= R / c.

/// rho of T as a matrix on (u_0, .., u_{n-1}), enclosed by the eigenfunction that inverse iteration
/// finds at the working precision. Empty where that is not proved to be positive.
std::optional<Ball> spectral_radius_by_eigenfunction(const SquareMatrix<Ball>& t);

/// A positive lower bound of u(w) for all w, from the coefficients of u as a polynomial in cos w in
/// Bernstein's basis: where all are positive, the least of them is one, else the interval is
/// halved. Empty if none is found after some halvings.
std::optional<Ball> positive_minimum(const std::vector<Ball>& u);

}  // namespace wavecurve::certified
