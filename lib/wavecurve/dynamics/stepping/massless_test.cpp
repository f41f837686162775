#include "wavecurve/dynamics/stepping/massless.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/dynamics/problem_test.hpp"

namespace wavecurve::dynamics {
namespace {

using enum MasslessMethod;

InitialValueProblem problem_of(const std::string& filter) {
  InitialValueProblem problem = smooth_problem(
      filter, 16,
      {.density = 0, .stiffness = 0.1, .stiffness_damping = 0.05, .damping_density = 1});
  problem.force.constant = uniform_density(problem.system, Eigen::RowVector2d(1, 0.5));
  problem.force.harmonic.push_back(
      {.omega = 3, .cosine = problem.initial_displacement, .sine = -problem.initial_displacement});
  return problem;
}

TEST(Massless, TendsToTheExactSolutionAtItsOrder) {
  for (const std::string filter : {"db4", "bspline4.4"}) {
    const InitialValueProblem problem = problem_of(filter);
    const Trajectory exact = solve_spectral(problem);
    for (const auto& [method, order] : {std::pair(schulz_euler, 1),
                                        {explicit_euler, 1},
                                        {backward_euler, 1},
                                        {crank_nicolson, 2}}) {
      const Trajectory coarse = solve_massless(problem, method, 1.0 / 64);
      const Trajectory fine = solve_massless(problem, method, 1.0 / 128);
      const double ratio = largest_difference(coarse.displacement, exact.displacement) /
                           largest_difference(fine.displacement, exact.displacement);
      EXPECT_NEAR(std::log2(ratio), order, 0.1) << filter << " method " << static_cast<int>(method);
      EXPECT_LT(largest_difference(fine.velocity, exact.velocity), 0.2);
      EXPECT_EQ(fine.cost.evaluations, 128);
    }
  }
}

TEST(Massless, IsTheLimitOfASmallDensity) {
  // u' = -(k / c) u: with a little mass, the same after the time density / c.
  Material material = {
      .density = 0, .stiffness = 0.1, .stiffness_damping = 0.05, .damping_density = 1};
  const Trajectory limit = solve_spectral(smooth_problem("db4", 16, material));
  double last = 1;
  for (const double density : {1e-2, 1e-3, 1e-4}) {
    material.density = density;
    const Trajectory solution = solve_spectral(smooth_problem("db4", 16, material));
    const double difference = largest_difference(solution.displacement, limit.displacement);
    EXPECT_LT(difference, 10 * density);
    EXPECT_LT(difference, 0.2 * last);
    last = difference;
  }
}

TEST(Massless, SolvesOneModeAsOnPaper) {
  // u' = -(k / c) u for mode 1: a step of size h multiplies by 1 - h k / c, 1 / (1 + h k / c), or
  // (1 - h k / 2 c) / (1 + h k / 2 c).
  InitialValueProblem problem = smooth_problem(
      "coif2", 32,
      {.density = 0, .stiffness = 0.1, .stiffness_damping = 0.05, .damping_density = 1});
  problem.initial_displacement.col(0) = problem.initial_displacement.col(1);
  const CirculantEigenvalues symbols = problem.system.eigenvalues();
  const double rate = symbols.stiffness[1] / symbols.damping[1], h = 1.0 / 64;
  for (const auto& [method, factor] : {std::pair(schulz_euler, 1 - h * rate),
                                       {explicit_euler, 1 - h * rate},
                                       {backward_euler, 1 / (1 + h * rate)},
                                       {crank_nicolson, (1 - h * rate / 2) / (1 + h * rate / 2)}}) {
    const Trajectory solution = solve_massless(problem, method, h);
    for (std::size_t i = 0; i < solution.displacement.size(); ++i) {
      const double expected = std::pow(factor, 64 * problem.times[static_cast<Eigen::Index>(i)]);
      // Residuals of the inverse and of the factorisation, 1e-12 at most in each of 64 steps.
      EXPECT_LT((solution.displacement[i] - expected * problem.initial_displacement).norm(), 1e-10);
      EXPECT_LT((solution.velocity[i] + rate * expected * problem.initial_displacement).norm(),
                1e-9);
    }
  }
}

TEST(Massless, IsLinearAndShiftsWithTheStartPoint) {
  const LagrangeSystem system(
      find_filter_bank<double>("db4"), 32, 2,
      {.density = 0, .stiffness = 0.1, .stiffness_damping = 0.05, .damping_density = 1});
  const Eigen::Index shift = 3 * 4;  // three times the coarsest spacing
  InitialValueProblem problem = {
      .system = system,
      .initial_displacement = coefficients_of(system, smooth_samples(32)),
      .times = Eigen::Vector2d(0.2, 0.5)};
  problem.force.harmonic.push_back(
      {.omega = 3, .cosine = problem.initial_displacement, .sine = -problem.initial_displacement});
  InitialValueProblem moved = problem;
  moved.initial_displacement = -2 * coefficients_of(system, smooth_samples(32, shift));
  moved.force.harmonic = {
      {.omega = 3, .cosine = moved.initial_displacement, .sine = -moved.initial_displacement}};
  for (const MasslessMethod method :
       {schulz_euler, explicit_euler, backward_euler, crank_nicolson}) {
    const Trajectory original = solve_massless(problem, method, 1.0 / 64);
    Trajectory other = solve_massless(moved, method, 1.0 / 64);
    for (Eigen::MatrixXd& state : other.displacement) {
      state = -0.5 * shifted(system, state, 32 - shift);
    }
    EXPECT_LT(largest_difference(other.displacement, original.displacement), 1e-10);
  }
}

TEST(Massless, SeesForcesThatDependOnTheState) {
  // f = -a u adds a G to K: the exact solution has the rate (k + a g) / c.
  const double a = 0.7;
  InitialValueProblem problem = smooth_problem(
      "db4", 16, {.density = 0, .stiffness = 0.1, .stiffness_damping = 0.05, .damping_density = 1});
  problem.force.general.push_back(
      [a](double, const Eigen::Ref<const Eigen::MatrixXd>& u, const auto&) { return -a * u; });
  const CirculantEigenvalues s = problem.system.eigenvalues();
  problem.initial_displacement.col(0) = problem.initial_displacement.col(1);  // mode 1 alone
  const double rate = (s.stiffness[1] + a) / s.damping[1];
  for (const auto& [method, bound] :
       {std::pair(schulz_euler, 1e-2), {backward_euler, 1e-2}, {crank_nicolson, 1e-4}}) {
    const Trajectory solution = solve_massless(problem, method, 1.0 / 128);
    EXPECT_LT((solution.displacement[4] - std::exp(-rate) * problem.initial_displacement).norm(),
              bound * problem.initial_displacement.norm());
  }
}

TEST(Massless, RefusesStepsBeyondTheStabilityBound) {
  InitialValueProblem problem = problem_of("db4");
  problem.initial_displacement.setRandom();
  const double bound = stability_bound(problem.system);
  problem.times = Eigen::VectorXd::Constant(1, 60 * bound);  // 50 steps, each 1.4 times the last
  EXPECT_GT(bound, 0);
  for (const MasslessMethod method : {schulz_euler, explicit_euler}) {
    EXPECT_THROW(solve_massless(problem, method, 1.01 * bound), std::domain_error);
    const Trajectory stable = solve_massless(problem, method, 0.99 * bound);
    const Trajectory unstable = solve_massless(problem, method, 1.2 * bound, true);
    EXPECT_GT(unstable.velocity[0].norm(), 1e3 * stable.velocity[0].norm());
  }
  EXPECT_NO_THROW(solve_massless(problem, backward_euler, 10 * bound));
}

TEST(Massless, RefusesASingularC) {
  const InitialValueProblem problem =
      smooth_problem("db4", 16, {.density = 0, .stiffness_damping = 1});
  for (const MasslessMethod method : {schulz_euler, explicit_euler, backward_euler}) {
    EXPECT_THROW(solve_massless(problem, method, 1e-3), std::domain_error);
  }
  EXPECT_THROW(solve_spectral(problem), std::domain_error);
}

}  // namespace
}  // namespace wavecurve::dynamics
