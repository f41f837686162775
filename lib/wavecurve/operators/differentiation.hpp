#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

// Differentiation matrices of functions with period 1, f(x) = sum_n c_n phi(N x - n), n = 0 .. N - 1, for
// any N >= 1, as the first column of a circulant: entry (i, j) = column_{(i - j) mod N}. In the terms
// of Mehra and Goyal 2013 (ACM TOMS Algorithm 929, periodic case).

/// The Galerkin method: from the coefficients c of f to those of the projection of f^(d) on the
/// same space along the dual functions,
///   column_r = N^d sum_k r_{r + kN},   r_l = int phi^(d)(x) phi~(x - l) dx.
/// It commutes with the circulant of phi's values, so that it takes f(n / N) to the values of that
/// projection too. With p vanishing moments of either side together, 2p of an orthonormal filter's p,
/// the coefficients of a smooth f^(d) are met with the order p - d, one more for odd d: in
/// sum_k (i (w + 2 pi k))^d phi^(w + 2 pi k) conj(phi~^(w + 2 pi k)) the terms k != 0 are O(w^p), and
/// those of k and -k cancel for odd d and real filters.
///
/// Throws std::invalid_argument for samples outside 1 .. 2^24 or d outside 0 .. highest_derivative,
/// std::domain_error as product_integrals does.
Eigen::VectorXd galerkin_differentiation(const FilterBank<double>& bank, Eigen::Index samples,
                                         int d);

/// The collocation method: from the values f(n / N) to the values f^(d)(n / N), f of the space. With
/// the circulants of phi(n) and phi^(d)(n), N^d Phi_d Phi_0^-1, by the discrete Fourier transform. It
/// differentiates polynomials up to the degree of phi exactly and is a full matrix, whose entries decay
/// exponentially away from the diagonal.
///
/// Throws as above; std::domain_error as scaling_values does, and where the symbol of phi's values
/// is smaller than 1e-6 at some frequency, so that no f of the space has given values.
Eigen::VectorXd collocation_differentiation(const FilterBank<double>& bank, Eigen::Index samples,
                                            int d);

/// The circulant of a first column, without its zeros.
Eigen::SparseMatrix<double> circulant_matrix(const Eigen::Ref<const Eigen::VectorXd>& column);

}  // namespace wavecurve
