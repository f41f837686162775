#include "motion_error.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/dynamics/spectral.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

#include "named_shapes.hpp"

namespace wavecurve::verification {
namespace {

constexpr double rounding = 1e-12;

InitialValueProblem problem_of(const char* filter, const wavecurve::Material& material = {}) {
  const LagrangeSystem system(find_filter_bank<double>(filter), 32, 5, material);
  return released(system, named_shape("ellipse", 32), Eigen::VectorXd::LinSpaced(5, 0, 0.9));
}

TEST(MotionError, OfAMultipleIsItsExcess) {
  for (const char* filter : {"db4", "bspline4.4"}) {
    const InitialValueProblem problem = problem_of(filter);
    const Trajectory exact = solve_spectral(problem);
    Trajectory twice = exact;
    for (Eigen::MatrixXd& q : twice.displacement) q *= 2;
    for (Eigen::MatrixXd& v : twice.velocity) v *= 2;
    EXPECT_EQ(displacement_errors(problem, exact, exact).maxCoeff(), 0);
    EXPECT_NEAR(displacement_errors(problem, twice, exact)[0], 1, rounding);
    // Undamped, the energy stays that of the start.
    EXPECT_LT((energy_errors(problem, twice, exact).array() - 1).abs().maxCoeff(), 1e-10);
  }
}

TEST(MotionError, IsTheNormOfTheCurveAndNotOfItsCoefficients) {
  const InitialValueProblem problem = problem_of("bspline4.4");
  Trajectory exact, other;
  for (Eigen::Index i = 0; i < problem.times.size(); ++i) {
    exact.displacement.push_back(problem.displacement);
    other.displacement.push_back(problem.displacement);
    other.displacement.back()(17, 0) += 1;
  }
  const Eigen::MatrixXd form = gram(problem.system.bank(), 32, 5);
  const Eigen::MatrixXd& u = problem.displacement;
  const double unit = std::sqrt((u.transpose() * form * u).trace());
  EXPECT_NEAR(displacement_errors(problem, other, exact)[2], std::sqrt(form(17, 17)) / unit,
              rounding);
}

}  // namespace
}  // namespace wavecurve::verification
