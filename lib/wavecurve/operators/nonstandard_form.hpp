#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// The non-standard form of the derivative T = d^d / dx^d (Beylkin, Coifman and Rokhlin 1991, III): with
/// the projections P_j on the shifts of phi of level j, and Q_j on those of psi,
///   P_J T P_J = P_0 T P_0 + sum_{j<J} (Q_j T Q_j + Q_j T P_j + P_j T Q_j).
/// Unlike the standard form (multiscale_matrix) it has no block between different levels, and on
/// every level the same ones but for a factor: entry (i, k) of level j is 2^(j d) times
///   a_{k-i} = int psi(x - i) T psi(x - k) dx,   b: of psi, T phi,   c: of phi, T psi,
///   r: of phi, T phi, on the coarsest level alone.
struct NonstandardForm {
  int derivative = 1;
  Filter<double> a, b, c, r;
};

/// Throws std::invalid_argument unless the bank is orthonormal and the derivative from 0 to
/// highest_derivative, std::domain_error as product_integrals does.
NonstandardForm nonstandard_form(const FilterBank<double>& bank, int derivative);

/// P_J T P_J on the coefficients of the periodized 2^(J/2) phi(2^J x - n) on the unit interval, by that
/// form with so many levels. Up to rounding that is the circulant matrix of r, times 2^(J d). The
/// number of operations is a constant times the number of coefficients. Throws
/// std::invalid_argument unless 2^levels divides their number.
Eigen::VectorXd apply(const NonstandardForm& form, const FilterBank<double>& bank,
                      const Eigen::Ref<const Eigen::VectorXd>& coefficients, int levels);

/// The form as one matrix, as it is drawn: on the diagonal a block [A B; C 0] for each level, the
/// coarsest first, whose zero is r's block. A block acts on the wavelet coefficients and then the
/// scaling coefficients of its level, samples / 2^i of each, i = levels .. 1; entries have the factor
/// (samples / 2^i)^d. Throws std::invalid_argument unless samples is a power of two and levels from 1 to
/// its exponent.
Eigen::SparseMatrix<double> nonstandard_matrix(const NonstandardForm& form, Eigen::Index samples,
                                               int levels);

}  // namespace wavecurve
