#pragma once

#include <vector>

#include <Eigen/SparseCore>

namespace wavecurve::dynamics {

/// How an iteration ended.
enum class SchulzStatus {
  converged,  ///< the residual is at most the tolerance
  stagnated,  ///< rounding, or dropping, keeps the residual above the tolerance, but below 1
  singular,   ///< to working precision the matrix has no inverse; X is near its pseudo-inverse
};

/// X and how it came about. Matrix is dense or sparse.
template <class Matrix>
struct SchulzInverse {
  Matrix inverse;
  std::vector<double> residuals;  ///< ||I - X_n C||_F, n = 0, 1, ..., the last that of inverse
  SchulzStatus status = SchulzStatus::stagnated;
  /// A bound of ||X - C^-1||_F, rounding of the last residual aside: r ||X||_F / (1 - r), r the
  /// last residual; infinite for r >= 1. Whatever dropping and rounding did to X on the way is in
  /// r.
  double error_bound = 0;
  std::vector<double> dropped;  ///< Frobenius norm of what each step dropped; sparse only
};

/// Schulz' iteration, X_{n+1} = 2 X_n - X_n C X_n, X_0 = C^T / ||C^T C||: the residual is squared
/// in every step, R_{n+1} = R_n^2, R_n = I - X_n C. Publication, section 3.3.
///
/// It converges if the norm is at least the spectral one, and each factor that it exceeds it by
/// costs a factor in X_0, that is log2 of it in steps. The largest sum of |entries| in a row is
/// such a bound for C^T C, near the spectral norm for the banded matrices here, where the Frobenius
/// norm would be too large by the root of the size. About 2 log2(condition number) steps come
/// before the residual falls; in the end it is about the condition number times the unit of
/// rounding.
///
/// The residual of a singular matrix stays at least 1: R_n z = z for a null vector z. X_n tends to
/// the pseudo-inverse, while rounding along z doubles with each step. That is seen when C X C = C
/// holds to rounding with a residual still at least 1/2. There are at most 140 steps: more than a
/// condition number of 2^52 takes.
///
/// Throws std::invalid_argument unless C is square, not empty and finite.
SchulzInverse<Eigen::MatrixXd> schulz_inverse(const Eigen::Ref<const Eigen::MatrixXd>& c,
                                              double tolerance);

/// The same with sparse matrices, which throws std::domain_error where the products take more than
/// 3e9 multiplications, as where the inverse of a large matrix fills up; after every step entries below threshold times the largest of X
/// are dropped.
SchulzInverse<Eigen::SparseMatrix<double>> schulz_inverse(const Eigen::SparseMatrix<double>& c,
                                                          double tolerance, double threshold);

}  // namespace wavecurve::dynamics
