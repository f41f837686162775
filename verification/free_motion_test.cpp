#include "free_motion.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::verification {
namespace {

/// rho q'' + c q' + k q by central differences, relative to the largest that the terms can be. With
/// R a bound of the roots, the step 1e-3 / R gives a truncation error of 1e-6 and rounding of 1e-9.
double residual(double rho, double c, double k, double tau) {
  const double bound = c / rho + std::sqrt(k / rho) + 1;
  const double h = 1e-3 / bound;
  const auto q = [&](double t) { return free_oscillation(rho, c, k, 1, -0.5, t); };
  const double second = (q(tau + h) - 2 * q(tau) + q(tau - h)) / (h * h);
  const double first = (q(tau + h) - q(tau - h)) / (2 * h);
  return std::abs(rho * second + c * first + k * q(tau)) / (rho * bound * bound);
}

RC_GTEST_PROP(FreeOscillation, SolvesItsEquationBelowAtAndAboveCriticalDamping, ()) {
  const double rho = *rc::gen::inRange(1, 40) / 10.0;
  const double c = *rc::gen::inRange(0, 80) / 10.0;
  const double k = *rc::gen::inRange(0, 200) / 10.0;
  const double tau = *rc::gen::inRange(0, 20) / 10.0;
  RC_ASSERT(residual(rho, c, k, tau) < 1e-5);
  RC_ASSERT(residual(rho, 2 * std::sqrt(rho * k), k, tau) < 1e-5);
}

TEST(FreeOscillation, StartsWhereItIsPut) {
  for (const double c : {0.0, 1.0, 2.0, 40.0}) {
    EXPECT_DOUBLE_EQ(free_oscillation(1, c, 1, 0.7, -2, 0), 0.7);
    const double h = 1e-7;
    EXPECT_NEAR((free_oscillation(1, c, 1, 0.7, -2, h) - 0.7) / h, -2, 1e-4);
  }
  EXPECT_THROW(free_oscillation(0, 1, 1, 1, 0, 1), std::domain_error);
}

TEST(FreeMotion, ConservesTheEnergyWithoutDampingAndLosesItWithDamping) {
  Eigen::MatrixXd stiffness(3, 3);
  stiffness << 2, -1, -1, -1, 2, -1, -1, -1, 2;
  stiffness(0, 0) += 1;
  const Eigen::Vector3d start(1, -0.5, 0.25);
  const double rho = 2, h = 1e-5;
  const auto energy = [&](double s1, double tau) {
    const Eigen::Vector3d instants(tau - h, tau, tau + h);
    const Eigen::MatrixXd q = free_motion(stiffness, {rho, s1, 0}, start, instants);
    const Eigen::Vector3d velocity = (q.col(2) - q.col(0)) / (2 * h);
    return (rho * velocity.squaredNorm() + q.col(1).dot(stiffness * q.col(1))) / 2;
  };
  const double initial = start.dot(stiffness * start) / 2;
  EXPECT_NEAR(energy(0, 1.3), initial, 1e-8 * initial);
  EXPECT_LT(energy(1, 1.3), 0.6 * initial);
}

}  // namespace
}  // namespace wavecurve::verification
