#include "wavecurve/dynamics/stepping/detail/system_operator.hpp"

#include <limits>
#include <string>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/dynamics/problem_test.hpp"
#include "wavecurve/dynamics/solver.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

namespace wavecurve::dynamics {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// db10 and the cubic spline are smooth enough for bending.
LagrangeSystem bending_system(const std::string& filter, int levels) {
  return {find_filter_bank<double>(filter), 32, levels, {.stiffness = 0.7, .bending = 1e-3}};
}

TEST(SystemOperator, IsTheAssembledMatrixWithBendingToo) {
  for (const char* filter : {"db10", "bspline4.4"}) {
    for (const int levels : {0, 3, 5}) {
      const LagrangeSystem system = bending_system(filter, levels);
      const Eigen::MatrixXd k = system.stiffness();
      const Eigen::MatrixXd g = gram(system.bank(), 32, levels);
      const Eigen::MatrixXd x = Eigen::MatrixXd::Random(32, 2);
      Eigen::MatrixXd y(32, 2);
      SystemOperator(system, 0.3, 0.2).apply(x, y);
      const Eigen::MatrixXd matrix = 0.3 * g + 0.2 * k;
      EXPECT_LT((y - matrix * x).norm(), 1e3 * epsilon * matrix.norm() * x.norm()) << filter;
      ReducedStiffness(system).apply(x, y);
      // M^-1 K, of the condition of G: below 2^8 here.
      const Eigen::MatrixXd expected = g.llt().solve(k * x);
      EXPECT_LT((y - expected).norm(), 1e5 * epsilon * k.norm() * x.norm()) << filter;
    }
  }
}

TEST(SystemOperator, BendingMakesModesStifferByTheFourthPowerOfTheFrequency) {
  // The n-th mode of a free curve: omega^2 = e (2 pi n)^2 + b (2 pi n)^4, on the finest level up to
  // the error of its functions, below 1e-4 here.
  const LagrangeSystem system = bending_system("db10", 5);
  const CirculantEigenvalues symbols = system.eigenvalues();
  const double square = 4 * M_PI * M_PI;
  EXPECT_NEAR(symbols.stiffness[1] / (0.7 * square + 1e-3 * square * square), 1, 1e-4);
}

TEST(SystemOperator, SolversAgreeUnderBending) {
  for (const std::string filter : {"db10", "bspline4.4"}) {
    InitialValueProblem problem = smooth_problem(
        filter, 32,
        {.stiffness = 0.7, .bending = 1e-3, .mass_damping = 0.1, .stiffness_damping = 1e-4});
    const Trajectory exact = solve_spectral(problem);
    const Trajectory coupled = find_solver("coupled").make({.tolerance = 1e-8})(problem);
    const Trajectory rosenbrock =
        find_solver("implicit-rosenbrock-ldlt").make({.tolerance = 1e-6})(problem);
    EXPECT_LT(largest_difference(coupled.displacement, exact.displacement), 1e-5) << filter;
    EXPECT_LT(largest_difference(rosenbrock.displacement, exact.displacement), 1e-3) << filter;
  }
}

}  // namespace
}  // namespace wavecurve::dynamics
