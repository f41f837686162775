#include "verification/study/motion_error.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

#include "verification/study/named_shapes.hpp"

namespace wavecurve::verification {
namespace {

constexpr double rounding = 1e-12;

dynamics::InitialValueProblem problem_of(const char* filter,
                                         const wavecurve::dynamics::Material& material = {}) {
  const dynamics::LagrangeSystem system(find_filter_bank<double>(filter), 32, 5, material);
  return released(system, named_shape("ellipse", 32), Eigen::VectorXd::LinSpaced(5, 0, 0.9));
}

TEST(MotionError, IsTheExcessOfAMultiple) {
  for (const char* filter : {"db4", "bspline4.4"}) {
    const dynamics::InitialValueProblem problem = problem_of(filter);
    const dynamics::Trajectory exact = dynamics::solve_spectral(problem);
    dynamics::Trajectory twice = exact;
    for (Eigen::MatrixXd& q : twice.displacement) q *= 2;
    for (Eigen::MatrixXd& v : twice.velocity) v *= 2;
    EXPECT_EQ(displacement_errors(problem, exact, exact).maxCoeff(), 0);
    EXPECT_NEAR(displacement_errors(problem, twice, exact)[0], 1, rounding);
    // Undamped, the energy stays that of the start.
    EXPECT_LT((energy_errors(problem, twice, exact).array() - 1).abs().maxCoeff(), 1e-10);
  }
}

TEST(MotionError, IsTheNormOfTheCurveAndNotOfItsCoefficients) {
  const dynamics::InitialValueProblem problem = problem_of("bspline4.4");
  dynamics::Trajectory exact, other;
  for (Eigen::Index i = 0; i < problem.times.size(); ++i) {
    exact.displacement.push_back(problem.initial_displacement);
    other.displacement.push_back(problem.initial_displacement);
    other.displacement.back()(17, 0) += 1;
  }
  const Eigen::MatrixXd form = gram(problem.system.bank(), 32, 5);
  const Eigen::MatrixXd& u = problem.initial_displacement;
  const double unit = std::sqrt((u.transpose() * form * u).trace());
  EXPECT_NEAR(displacement_errors(problem, other, exact)[2], std::sqrt(form(17, 17)) / unit,
              rounding);
}

TEST(MotionError, MaximumIsOfPointsAndVelocityOfTheLargest) {
  const dynamics::InitialValueProblem problem = problem_of("db4");
  const dynamics::Trajectory exact = dynamics::solve_spectral(problem);
  dynamics::Trajectory other = exact;
  for (Eigen::MatrixXd& q : other.displacement) q += 0.5 * problem.initial_displacement;
  for (Eigen::MatrixXd& v : other.velocity) v *= 3;
  const Eigen::VectorXd maximum = maximum_errors(problem, other, exact);
  const Eigen::VectorXd velocity = velocity_errors(problem, other, exact);
  EXPECT_LT((maximum.array() - 0.5).abs().maxCoeff(), rounding);
  EXPECT_NEAR(velocity.maxCoeff(), 2, rounding);
  EXPECT_EQ(velocity[0], 0);  // released at rest
  // One point moved by a tenth, in samples.
  Contour moved = Contour::Zero(32, 2);
  moved.row(7) << 0.06, 0.08;
  other.displacement[3] =
      exact.displacement[3] + Eigen::MatrixXd(to_coefficients(problem.system.bank(), moved, 5));
  // The ellipse's points are 0.4 from the circle's, all of them.
  EXPECT_NEAR(maximum_errors(problem, other, exact)[3], 0.1 / 0.4, rounding);
}

TEST(MotionError, EnergyDriftIsChangeUndampedAndIncreaseDamped) {
  for (const double s1 : {0.0, 2.0}) {
    const dynamics::InitialValueProblem problem = problem_of("bspline4.4", {.mass_damping = s1});
    dynamics::Trajectory solution = dynamics::solve_spectral(problem);
    EXPECT_LT(energy_drift(problem, solution), 1e-10);
    if (s1 == 0) {
      EXPECT_LT((energies(problem, solution).array() - 1).abs().maxCoeff(), 1e-10);
    }
    // Less energy is a drift only where nothing takes it away.
    solution.displacement[4] *= 0.5;
    solution.velocity[4] *= 0.5;
    if (s1 == 0) {
      EXPECT_NEAR(energy_drift(problem, solution), 0.75, 1e-10);
    } else {
      EXPECT_LT(energy_drift(problem, solution), 1e-10);
      solution.displacement[4] *= 20;
      solution.velocity[4] *= 20;
      const Eigen::VectorXd energy = energies(problem, solution);
      EXPECT_NEAR(energy_drift(problem, solution), energy[4] - energy[3], rounding);
      EXPECT_GT(energy[4], energy[3]);
    }
  }
}

}  // namespace
}  // namespace wavecurve::verification
