#include "wavecurve/dynamics/stepping/detail/shifted_solver.hpp"

#include <stdexcept>

#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

namespace wavecurve::dynamics {

namespace {

class Iteration : public ShiftedSolver {
 public:
  Iteration(const LagrangeSystem& system, double gram, double stiffness, double tolerance)
      : operator_(system, gram, stiffness), tolerance_(tolerance) {}

  void solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x) override {
    for (Eigen::Index j = 0; j < b.cols(); ++j) {
      const int iterations = conjugate_gradients(operator_, b.col(j), x.col(j), tolerance_, true);
      operations_ += (iterations + 1) * (operator_.operations() + 12 * b.rows());
    }
  }

 private:
  SystemOperator operator_;
  double tolerance_;
};

class Factorisation : public ShiftedSolver {
 public:
  Factorisation(const LagrangeSystem& system, double gram, double stiffness) {
    const Eigen::SparseMatrix<double> matrix =
        gram * wavecurve::gram(system.bank(), system.samples(), system.levels()) +
        stiffness * system.stiffness();
    factors_.compute(matrix);
    const double smallest = factors_.info() == Eigen::Success ? factors_.vectorD().minCoeff() : 0;
    if (!(smallest > 1e-15 * factors_.vectorD().maxCoeff())) {
      throw std::domain_error(
          fmt::format("the smallest pivot of {} G + {} K is {}: the matrix is singular", gram,
                      stiffness, smallest));
    }
    // As many products and sums as entries of the factor, forwards and backwards.
    operations_a_column_ = 4 * factors_.matrixL().nestedExpression().nonZeros() + matrix.rows();
  }

  void solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x) override {
    x = factors_.solve(Eigen::MatrixXd(b));
    operations_ += operations_a_column_ * b.cols();
  }

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
  long long operations_a_column_ = 0;
};

}  // namespace

std::unique_ptr<ShiftedSolver> shifted_solver(const LagrangeSystem& system, double gram,
                                              double stiffness, LinearSolver method,
                                              double tolerance) {
  if (!(gram > 0)) {
    throw std::domain_error(must_be("the factor of G", gram, "above 0: K alone is singular"));
  }
  if (method == LinearSolver::factorisation) {
    return std::make_unique<Factorisation>(system, gram, stiffness);
  }
  return std::make_unique<Iteration>(system, gram, stiffness, tolerance);
}

int conjugate_gradients(SystemOperator& a, const Eigen::Ref<const Eigen::VectorXd>& b,
                        Eigen::Ref<Eigen::VectorXd> x, double tolerance, bool is_preconditioned) {
  const auto most = static_cast<int>(10 * x.size() + 1000);
  const double bound = tolerance * b.norm();
  if (bound == 0) {
    x.setZero();
    return 0;
  }
  Eigen::VectorXd product(x.size()), residual, preconditioned, direction, inverse_diagonal;
  if (is_preconditioned) inverse_diagonal = a.diagonal().cwiseInverse();
  a.apply(x, product);
  residual = b - product;
  double last = 0;
  for (int iteration = 0;; ++iteration) {
    if (residual.norm() <= bound) return iteration;
    if (iteration == most) {
      throw std::runtime_error(
          fmt::format("conjugate gradients: the residual is {} of the right-hand side after {} "
                      "iterations, but must be at most {}",
                      residual.norm() / b.norm(), most, tolerance));
    }
    preconditioned = residual;
    if (is_preconditioned) preconditioned.array() *= inverse_diagonal.array();
    const double now = residual.dot(preconditioned);
    if (iteration == 0) direction = preconditioned;
    if (iteration > 0) direction = preconditioned + now / last * direction;
    last = now;
    a.apply(direction, product);
    const double step = now / direction.dot(product);
    x += step * direction;
    residual -= step * product;
  }
}

}  // namespace wavecurve::dynamics
