#pragma once

#include <memory>

#include <Eigen/Core>

#include "wavecurve/dynamics/lagrange_system.hpp"
#include "wavecurve/dynamics/stepping/detail/system_operator.hpp"

namespace wavecurve::dynamics {

/// How the linear systems of implicit methods are solved.
enum class LinearSolver {
  conjugate_gradients,  ///< matrix-free, preconditioned by the diagonal
  factorisation,        ///< sparse LDL^T of the assembled matrix
};

/// Solutions of (gram G + stiffness K) x = b, symmetric and positive definite for gram > 0. All
/// linear systems of implicit methods are of this form, since M, C and K are combinations of G and
/// K.
class ShiftedSolver {
 public:
  virtual ~ShiftedSolver() = default;
  /// x is the first guess, samples x coordinates, and becomes the solution. Throws
  /// std::runtime_error if the iteration does not converge.
  virtual void solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x) = 0;
  long long operations() const { return operations_; }  ///< so far

 protected:
  long long operations_ = 0;
};

/// tolerance is that of the iteration, see conjugate_gradients. Throws std::domain_error if the
/// matrix is singular.
std::unique_ptr<ShiftedSolver> shifted_solver(const LagrangeSystem& system, double gram,
                                              double stiffness, LinearSolver method,
                                              double tolerance);

/// The conjugate gradient method for A x = b, from the guess x on, until the residual is at most
/// tolerance |b|; preconditioned by the diagonal, or not. In the wavelet basis with all levels the
/// diagonal carries the growth of A, 4^level, and what is left has a condition number bounded in
/// the number of samples; hence so is the number of iterations, which is returned. Throws
/// std::runtime_error after 10 x.size() + 1000 iterations.
int conjugate_gradients(SystemOperator& a, const Eigen::Ref<const Eigen::VectorXd>& b,
                        Eigen::Ref<Eigen::VectorXd> x, double tolerance, bool is_preconditioned);

}  // namespace wavecurve::dynamics
