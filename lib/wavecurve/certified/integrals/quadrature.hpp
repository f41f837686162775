#pragma once

#include <vector>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/filter_definition.hpp"

namespace wavecurve::certified {

// Polynomials and a scaling function phi (or phi~: pass dual(definition)), by its moments M_p
// (moments.hpp).

/// int f(x) phi(x) dx is about sum_k weights_k f(nodes_k) (Sweldens and Piessens 1994).
struct QuadratureRule {
  std::vector<Ball> nodes, weights;
  /// The rule is exact for every polynomial up to this degree, proved; the next power is the first
  /// of which the rule is proved not to be, or cannot be proved to be exact.
  int degree = 0;
  /// int x^(degree+1) phi(x) dx less what the rule gives.
  Ball next_error;
};

/// One node, M_1, with the weight 1: degree 1, and degree 2 for an orthonormal bank of two or more
/// vanishing moments, since M_2 = M_1^2 there (Sweldens and Piessens 1994, section 3).
QuadratureRule one_point_rule(const FilterDefinition& definition, long bits);

/// The interpolatory rule with `count` nodes first, first + step, ..: its degree is count - 1. Its
/// weights, int L_k(x) phi(x) dx of Lagrange's polynomials, are exact combinations of
/// moments. Throws std::invalid_argument for count outside 1 .. most_nodes, and a step that is not
/// positive.
QuadratureRule equidistant_rule(const FilterDefinition& definition, const Rational& first,
                                const Rational& step, int count, long bits);

inline constexpr int most_nodes = 40;

/// The numbers a_p, p < N, by which the shifts of phi reproduce polynomials,
///   x^p = sum_l c_p(l) phi(x - l),   c_p(l) = sum_{k<=p} binomial(p, k) l^(p-k) a_k,
/// N the number of its degrees (vanishing_moments): a_p = int x^p phi~(x) dx, and a_0 = 1 is the
/// partition of unity.
std::vector<Ball> reproduction_coefficients(const FilterDefinition& definition, long bits);

}  // namespace wavecurve::certified
