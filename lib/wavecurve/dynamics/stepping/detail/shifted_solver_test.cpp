#include "wavecurve/dynamics/stepping/detail/shifted_solver.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/dynamics/problem_test.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

namespace wavecurve::dynamics {
namespace {

TEST(ShiftedSolver, SolvesToTheResidualByBothMethods) {
  for (const char* filter : {"db4", "bspline4.4"}) {
    const LagrangeSystem system(find_filter_bank<double>(filter), 64, 6, {.stiffness = 2});
    const Eigen::MatrixXd matrix =
        Eigen::MatrixXd(0.7 * gram(system.bank(), 64, 6) + 0.01 * system.stiffness());
    const Eigen::MatrixXd b = Eigen::MatrixXd::Random(64, 2);
    for (const LinearSolver method :
         {LinearSolver::conjugate_gradients, LinearSolver::factorisation}) {
      Eigen::MatrixXd x = Eigen::MatrixXd::Random(64, 2);
      shifted_solver(system, 0.7, 0.01, method, 1e-12)->solve(b, x);
      EXPECT_LT((matrix * x - b).norm(), 1e-11 * b.norm());
    }
    EXPECT_THROW(shifted_solver(system, 0, 1, LinearSolver::factorisation, 1), std::domain_error);
    SystemOperator a(system, 0.7, 0.01);
    EXPECT_LT((a.diagonal() - matrix.diagonal()).norm(), 1e-12 * matrix.norm());
  }
}

int iterations(Eigen::Index samples, bool is_preconditioned) {
  const auto levels = static_cast<int>(std::lround(std::log2(static_cast<double>(samples))));
  const LagrangeSystem system(find_filter_bank<double>("db4"), samples, levels, {});
  SystemOperator a(system, 1, 1);
  Eigen::VectorXd b(samples), x = Eigen::VectorXd::Zero(samples);
  // Without structure, and the same on every machine.
  for (Eigen::Index i = 0; i < samples; ++i)
    b[i] = std::sin(1e4 * static_cast<double>(i * i % 9973));
  return conjugate_gradients(a, b, x, 1e-8, is_preconditioned);
}

TEST(ConjugateGradients, NeedIterationsBoundedInTheSizeWithTheDiagonal) {
  std::vector<int> with;
  for (int level = 8; level <= 16; level += 2) with.push_back(iterations(1 << level, true));
  const auto [least, most] = std::minmax_element(with.begin(), with.end());
  EXPECT_LE(*most, 1.5 * *least) << *least << " to " << *most;
  // The root of the condition number, 4^level: twice as many iterations for twice the samples.
  const double growth = std::log2(iterations(512, false) / double(iterations(128, false))) / 2;
  EXPECT_GT(growth, 0.7);
}

}  // namespace
}  // namespace wavecurve::dynamics
