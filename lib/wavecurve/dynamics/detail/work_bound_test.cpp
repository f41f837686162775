#include "wavecurve/dynamics/detail/work_bound.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/dynamics/problem_test.hpp"
#include "wavecurve/dynamics/solver.hpp"

namespace wavecurve::dynamics {
namespace {

TEST(WorkBound, JudgesByTheRateSoFar) {
  const auto spent = static_cast<long long>(most_operations / 10);
  EXPECT_NO_THROW(check_work(spent, 0.1, 1));
  EXPECT_THROW(check_work(spent, 0.099, 1), std::domain_error);
  EXPECT_THROW(check_work(spent, 0, 1), std::domain_error);
  EXPECT_NO_THROW(check_work(spent / 10, 0, 1));  // too early
  EXPECT_NO_THROW(check_work(10 * spent));
  EXPECT_THROW(check_work(11 * spent), std::domain_error);
}

TEST(WorkBound, ExplicitSolversRefuseStiffProblemsAtOnce) {
  // The largest eigenvalue of K grows with the square of the samples, and damping by K of the same kind
  // demands steps of its reciprocal: 10^7 steps and more.
  Material material;
  material.stiffness_damping = 10;
  InitialValueProblem problem = smooth_problem("db4", 2048, material);
  problem.times = Eigen::VectorXd::LinSpaced(3, 0, 100);
  for (const char* name : {"coupled", "coupled-cash-karp", "coupled-dormand-prince"}) {
    const Solver solver = find_solver(name).make({.tolerance = 1e-6});
    EXPECT_THROW(solver(problem), SolutionStopped) << name;
  }
  EXPECT_NO_THROW(find_solver("spectral").make({})(problem));
}

}  // namespace
}  // namespace wavecurve::dynamics
