#pragma once

#include <Eigen/SparseCore>

#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/operators/connection_coefficients.hpp"

namespace wavecurve {

/// The operator of derivative orders (p, q) in the periodized multiscale basis of the synthesis
/// side,
///   entry (i, j) = int_0^1 b_i^(p)(x) b_j^(q)(x) dx,  i, j in global-to-local order (see Band),
/// on the unit parameter interval with unit factor, all cross-level blocks included. Size samples x
/// samples, samples = 2^J; levels 0 .. J, where 0 gives the single-scale circulant. It equals
/// S^T T S with the synthesis matrix S and the circulant T of the finest level
/// (plain::multiscale_matrix), but is assembled in time and memory proportional to its non-zeros:
/// between two bands the entry depends on (n - 2^delta k) mod 2^j only, and follows from the
/// connection coefficients by delta two-scale relations. Entries that are exactly zero are left
/// out. Symmetric for even p + q, antisymmetric for odd, exactly.
///
/// Throws std::invalid_argument unless samples is a power of two up to 2^24 and 0 <= levels <= J,
/// or if the non-zeros exceed an int; as connection_coefficients does for p, q and the bank.
/// Publication, section 3.2, (3.8)-(3.9), and the blocks that it leaves out.
Eigen::SparseMatrix<double> multiscale_matrix(const FilterBank<double>& bank, Eigen::Index samples,
                                              int levels, int p, int q);
Eigen::SparseMatrix<double> multiscale_matrix(const FilterBank<double>& bank,
                                              const ConnectionCoefficients<double>& coefficients,
                                              Eigen::Index samples, int levels);

/// K, (p, q) = (1, 1), e_0 = 1: its first non-zero eigenvalue tends to (2 pi)^2. Positive
/// semi-definite; its null space are the constants (ones for the scaling, zeros for the wavelets).
Eigen::SparseMatrix<double> stiffness(const FilterBank<double>& bank, Eigen::Index samples,
                                      int levels);

/// The Gram matrix M, (p, q) = (0, 0), rho = 1: positive definite, and exactly the identity for an
/// orthonormal bank.
Eigen::SparseMatrix<double> gram(const FilterBank<double>& bank, Eigen::Index samples, int levels);

/// Rayleigh damping C = s1 M + s2 K. Publication, (3.5).
Eigen::SparseMatrix<double> damping(const FilterBank<double>& bank, Eigen::Index samples,
                                    int levels, double s1, double s2);

}  // namespace wavecurve

namespace wavecurve::plain {

/// The plain twin: S^T T S, dense, S from plain::inverse_transform on unit vectors.
Eigen::MatrixXd multiscale_matrix(const FilterBank<double>& bank,
                                  const ConnectionCoefficients<double>& coefficients,
                                  Eigen::Index samples, int levels);

}  // namespace wavecurve::plain
