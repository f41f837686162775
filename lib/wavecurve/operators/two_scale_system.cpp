#include "wavecurve/operators/two_scale_system.hpp"

#include <cmath>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <Spectra/GenEigsRealShiftSolver.h>
#include <Spectra/MatOp/DenseGenRealShiftSolve.h>

#include "wavecurve/elementary/root.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/two_scale_matrix.hpp"

namespace wavecurve {

namespace {

/// l^d (with 0^0 = 1) for each unknown, counted for l and -l: the left-hand side of the moment
/// condition. It is also the left null vector of A up to the counting, which is why the last
/// equation, and not the one of l = 0, may be replaced.
Eigen::VectorXd moment_row(Eigen::Index unknowns, int d) {
  Eigen::VectorXd row(unknowns);
  for (Eigen::Index i = 0; i < unknowns; ++i) {
    const auto l = static_cast<double>(first_two_scale_unknown(d) + i);
    row[i] = whole_power(l, d) * (l == 0 ? 1.0 : 2.0);
  }
  return row;
}

/// (-1)^d d!
double moment(int d) {
  double product = 1;
  for (int i = 1; i <= d; ++i) product *= -i;
  return product;
}

Eigen::VectorXd singular_vector(const Eigen::MatrixXd& a) {
  return a.jacobiSvd(Eigen::ComputeFullV).matrixV().rightCols<1>();
}

Eigen::VectorXd eigenvector(const Eigen::MatrixXd& a) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(a);
  if (solver.info() != Eigen::Success)
    throw std::domain_error("the eigenvalues of A did not converge");
  Eigen::Index nearest = 0;
  solver.eigenvalues().cwiseAbs().minCoeff(&nearest);
  return solver.eigenvectors().col(nearest).real();
}

/// A's other eigenvalues are 2^k - 1 or nearer to -1 than -1/2 (for a smooth phi), so that any
/// small shift singles out the one near zero; at exactly zero the factorisation would fail.
Eigen::VectorXd shift_invert(const Eigen::MatrixXd& a) {
  constexpr Eigen::Index smallest_for_iteration = 6;
  if (a.rows() < smallest_for_iteration) return eigenvector(a);
  constexpr double shift = 1e-3;
  Spectra::DenseGenRealShiftSolve<double> operation(a);
  const Eigen::Index basis = std::min<Eigen::Index>(a.rows(), 20);
  Spectra::GenEigsRealShiftSolver<Spectra::DenseGenRealShiftSolve<double>> solver(operation, 1,
                                                                                  basis, shift);
  solver.init();
  constexpr int iterations = 1000;
  constexpr double tolerance = 1e-15;
  bool converged = false;
  try {
    solver.compute(Spectra::SortRule::LargestMagn, iterations, tolerance);
    converged = solver.info() == Spectra::CompInfo::Successful;
  } catch (const std::runtime_error&) {  // its inner decomposition, of a matrix that overflows
  }
  if (!converged) {
    throw std::domain_error("the shift-invert iteration for the null vector did not converge");
  }
  return solver.eigenvectors().col(0).real();
}

Eigen::VectorXd constrained(Eigen::MatrixXd a, int d) {
  a.bottomRows<1>() = moment_row(a.cols(), d).transpose();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(a.rows());
  right[a.rows() - 1] = moment(d);
  return a.partialPivLu().solve(right);
}

Eigen::VectorXd unscaled_null_vector(const Eigen::MatrixXd& a, int d, NullVectorMethod method) {
  switch (method) {
    case NullVectorMethod::singular_vector:
      return singular_vector(a);
    case NullVectorMethod::eigenvector:
      return eigenvector(a);
    case NullVectorMethod::shift_invert:
      return shift_invert(a);
    case NullVectorMethod::constrained:
      return constrained(a, d);
  }
  throw std::invalid_argument("unknown method for the null vector");
}

}  // namespace

Eigen::MatrixXd two_scale_matrix(const Eigen::Ref<const Eigen::VectorXd>& alpha, int d) {
  const auto coefficients = static_cast<int>(alpha.size());
  check_two_scale_arguments(d, coefficients);
  const int unknowns = coefficients - 1 - first_two_scale_unknown(d);
  Eigen::MatrixXd a(unknowns, unknowns);
  fill_two_scale_matrix(std::span<const double>(alpha.data(), alpha.size()), d, a);
  return a;
}

Eigen::VectorXd two_scale_null_vector(const Eigen::Ref<const Eigen::VectorXd>& alpha, int d,
                                      NullVectorMethod method) {
  const Eigen::VectorXd vector = unscaled_null_vector(two_scale_matrix(alpha, d), d, method);
  return vector * (moment(d) / moment_row(vector.size(), d).dot(vector));
}

}  // namespace wavecurve
