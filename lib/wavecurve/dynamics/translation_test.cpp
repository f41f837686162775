#include "wavecurve/dynamics/translation.hpp"

#include <string>

#include <gtest/gtest.h>

#include "wavecurve/dynamics/problem_test.hpp"

namespace wavecurve::dynamics {
namespace {

InitialValueProblem falling(const std::string& filter) {
  InitialValueProblem problem = smooth_problem(filter, 32, {});
  problem.initial_displacement += uniform_density(problem.system, Eigen::RowVector2d(2, -1));
  problem.force.constant = uniform_density(problem.system, Eigen::RowVector2d(0, -4));
  return problem;
}

TEST(Translation, TheMeanIsThatOfTheSamples) {
  for (const std::string filter : {"db4", "bspline4.4"}) {
    const LagrangeSystem system(find_filter_bank<double>(filter), 32, 3, {});
    const Eigen::MatrixXd samples = Eigen::MatrixXd::Random(32, 2);
    const Eigen::RowVectorXd expected = samples.colwise().mean();
    EXPECT_LT((mean(system, coefficients_of(system, samples)) - expected).norm(), 1e-14);
  }
}

TEST(Translation, MovesTheMeanAsSaidAndNothingElse) {
  for (const std::string filter : {"db4", "bspline4.4"}) {
    const InitialValueProblem problem = falling(filter);
    const LagrangeSystem& system = problem.system;
    for (const char* name : {"spectral", "decoupled", "coupled"}) {
      const Solver solver = find_solver(name).make({.tolerance = 1e-10});
      const Trajectory free = with_translation(solver, Translation::free)(problem);
      for (const auto& [mode, end] :
           {std::pair(Translation::held, 1.0), {Translation::interpolated, 0.0}}) {
        const Trajectory moved = with_translation(solver, mode)(problem);
        for (std::size_t i = 0; i < 5; ++i) {
          const double t = problem.times[static_cast<Eigen::Index>(i)];
          const Eigen::RowVectorXd m = mean(system, moved.displacement[i]);
          const double share = 1 + (end - 1) * t;
          EXPECT_LT((m - share * Eigen::RowVector2d(2, -1)).norm(), 1e-9) << name;
          EXPECT_LT(
              (mean(system, moved.velocity[i]) - (end - 1) * Eigen::RowVector2d(2, -1)).norm(),
              1e-7)
              << name;
          const Eigen::RowVectorXd fallen = mean(system, free.displacement[i]);
          EXPECT_LT((fallen - Eigen::RowVector2d(2, -1 - 2 * t * t)).norm(), 1e-8) << name;
          EXPECT_LT((moved.displacement[i] - uniform_density(system, m) - free.displacement[i] +
                     uniform_density(system, fallen))
                        .norm(),
                    1e-6)
              << name;
        }
      }
    }
  }
}

TEST(Translation, GeneralForcesSeeTheWholeMotion) {
  InitialValueProblem problem = falling("db4");
  problem.force = {};
  Eigen::RowVector2d seen(0, 0);
  problem.force.general.push_back(
      [&seen](double, const Eigen::Ref<const Eigen::MatrixXd>& positions, const auto&) {
        seen = positions.colwise().mean();
        return Eigen::MatrixXd::Ones(positions.rows(), positions.cols());
      });
  const Trajectory held = with_translation(find_solver("spectral").make({.tolerance = 1e-8}),
                                           Translation::held)(problem);
  EXPECT_LT((seen - Eigen::RowVector2d(2, -1)).norm(), 1e-9);
  EXPECT_LT((mean(problem.system, held.displacement[4]) - Eigen::RowVector2d(2, -1)).norm(), 1e-9);
}

}  // namespace
}  // namespace wavecurve::dynamics
