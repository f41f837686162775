#pragma once

#include <Eigen/Core>

namespace wavecurve {

// The homogeneous two-scale system A mu = 0 of the publication, (3.10) and (3.11), in double
// precision; filters/two_scale_matrix.hpp has its formula and which mu_l are its unknowns.

/// How the null vector of A is found.
enum class NullVectorMethod {
  singular_vector,  ///< right singular vector of the smallest singular value (Eigen, Jacobi)
  eigenvector,      ///< eigenvector of the eigenvalue nearest zero (Eigen, dense QR)
  shift_invert,     ///< the same by Spectra's shift-invert iteration, for long filters
  constrained,      ///< the last equation replaced by the moment condition (LU); the default
};

/// A, one row an equation, from alpha_0 .. alpha_P. Throws std::invalid_argument if alpha has too
/// few entries for one unknown, or d lies outside 0 .. 16.
Eigen::MatrixXd two_scale_matrix(const Eigen::Ref<const Eigen::VectorXd>& alpha, int d = 2);

/// The null vector, scaled to the moment condition sum_l l^d F^(d)(l) = (-1)^d d! over all integers
/// (certified/refinable.hpp has the proof). A rounded alpha makes A regular; then each method
/// returns what it makes of that, and they differ: the verification of published tables is about
/// this. The sign is that of F^(d), so that mu = (-1)^p times the result. Throws std::domain_error
/// if an iteration does not converge.
Eigen::VectorXd two_scale_null_vector(const Eigen::Ref<const Eigen::VectorXd>& alpha, int d,
                                      NullVectorMethod method);

}  // namespace wavecurve
