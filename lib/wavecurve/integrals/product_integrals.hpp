#pragma once

#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/integrals/product_integral.hpp"
#include "wavecurve/integrals/shift_tensor.hpp"

namespace wavecurve {

/// Connection coefficients of any number of factors, in double precision:
///   I(l, m, ..) = int x^p f_1(2^j1 x - l_1) .. f_k(2^jk x - l_k) dx
/// over the line or an interval, one dimension for each factor that is shifted, in their order;
/// product_integral.hpp says what may be asked. The two-scale relations of the factors give a
/// linear system for the integrals of scaling functions, derivatives are taken as differences,
/// wavelets, finer levels and dyadic intervals follow by the two-scale relations
/// (certified/integrals/product_integrals.hpp has the derivation, and the enclosures).
///
/// Time grows with the cube of the unknowns of the system, memory with their square: W^k - (W-1)^k
/// of them on the line, W^k on an interval, for k factors on supports of length W, fewer where
/// factors are equal.
///
/// Throws std::domain_error where the Sobolev exponent of phi is not above the one that is needed
/// (that of a phi~ of its own is not looked at here, but by certified::product_integrals), or if
/// the system is singular; std::invalid_argument as check_integral does and beyond most_unknowns
/// and most_integrals.
ShiftTensor<double> product_integrals(const FilterBank<double>& bank,
                                      const ProductIntegral& integral);

}  // namespace wavecurve
