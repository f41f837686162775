#include "verification/study/free_motion.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

TEST(FreeMotion, ConservesTheEnergyWithoutDampingAndLosesItWithDamping) {
  Eigen::MatrixXd stiffness(3, 3);
  stiffness << 2, -1, -1, -1, 2, -1, -1, -1, 2;
  stiffness(0, 0) += 1;
  const Eigen::Vector3d start(1, -0.5, 0.25);
  const double rho = 2, h = 1e-5;
  const auto energy = [&](double s1, double tau) {
    const Eigen::Vector3d instants(tau - h, tau, tau + h);
    const Eigen::MatrixXd q =
        free_motion(stiffness, {.density = rho, .mass_damping = s1}, start, instants);
    const Eigen::Vector3d velocity = (q.col(2) - q.col(0)) / (2 * h);
    return (rho * velocity.squaredNorm() + q.col(1).dot(stiffness * q.col(1))) / 2;
  };
  const double initial = start.dot(stiffness * start) / 2;
  EXPECT_NEAR(energy(0, 1.3), initial, 1e-8 * initial);
  EXPECT_LT(energy(1, 1.3), 0.6 * initial);
}

}  // namespace
}  // namespace wavecurve::verification
