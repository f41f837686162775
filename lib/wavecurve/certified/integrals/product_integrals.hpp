#pragma once

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/integrals/product_integral.hpp"
#include "wavecurve/integrals/shift_tensor.hpp"

namespace wavecurve::certified {

// Connection coefficients of any number of factors, with proof:
//   I(l, m, ..) = int x^p f_1(2^j1 x - l_1) .. f_k(2^jk x - l_k) dx
// over the line or an interval with dyadic ends, f_i any derivatives of phi, psi, phi~, psi~.
//
// The system. For refinable functions s_i(x) = sum_n a^i_n s_i(2x - n), int s_i = 1, put
//   D_p(y) = int x^p s_1(x) s_2(x - y_2) .. s_k(x - y_k) dx,
//   A_m(t) = 1/2 sum_n n^m a^1_n a^2_{n+t_2} .. a^k_{n+t_k},   (A_m D)(y) = sum_t A_m(t) D(2y + t).
// With x = (t + n)/2 under the integral,
//   D_p = 2^-p sum_{q<=p} binomial(p, q) A_{p-q} D_q.                                     (R)
// For p = 0 that is homogeneous, and since the shifts of all but one of the functions add up to 1,
//   sum_y D_0(y) = 1.                                                                     (S)
// (I - A_0 + u 1^T) D_0 = u holds for the integrals by (R) and (S); that this matrix is regular is
// proved in every case, and then there is no other solution: the rank of (R) is deficient by one.
// For p > 0 the matrix is I - 2^-p A_0. No equation has to be dropped.
//
// Derivatives. A mask a(z) with d zeros at z = -1 gives s^(d) = Delta^d s_d, (Delta f)(x) = f(x) -
// f(x-1), where s_d has the mask (2/(1+z))^d a(z) and int s_d = 1. So the integrals of derivatives
// are differences of integrals without. This replaces the moment equations of order d (Latto,
// Resnikoff and Tenenbaum 1991), of which d + 1 are needed for three factors, by (S), and the
// support is shorter by d.
//
// Intervals. The indicator of [0, 1] is refinable, with the mask (1, 1): an integral over [0, 1], a
// proper connection coefficient, is one over the line with one more factor; [a/2^j, b/2^j] is a sum
// of boxes. Wavelets, finer levels and intervals follow from the D_p by the two-scale relations.
//
// Existence. A product of functions of Sobolev exponents e_1 .. e_k (those of phi or phi~ less the
// derivatives; 1/2 for an interval) has an integral, as a continuous multilinear form, if
//   sum of any m >= 2 of the e_i > (m - 2)/2                                              (E)
// (multiplication in Sobolev spaces: Runst and Sickel 1996, section 4.4; Behzadan and Holst 2021).
// For int f f it is necessary as well; for other products it is a sufficient condition.
//
// The solution. The inverse is computed in double precision, the residual is bounded, and the
// solution is refined with residuals of the precision asked for
// (certified/detail/verified_inverse.hpp).

/// To this many bits relative to the largest of the integrals, as far as the definition allows; the
/// indices are those of the factors that are shifted, in their order. Throws std::domain_error
/// unless (E) is proved, naming the exponents found and needed, or if the system cannot be proved
/// regular; std::invalid_argument as check_integral does and beyond most_unknowns and
/// most_integrals.
ShiftTensor<Ball> product_integrals(const FilterDefinition& definition,
                                    const ProductIntegral& integral, long bits);

/// Throws std::domain_error unless (E) is proved.
void require_existence(const FilterDefinition& definition, const ProductIntegral& integral);

}  // namespace wavecurve::certified
